#pragma once

#include <string>

class SoNode;

namespace haptiv {

/// The first PROTO of the graph, or of what they made; null: there is none. The text of such a graph can be read again,
/// but what is written after that cannot: saveScene writes out what they made.
const SoNode* findPrototype(SoNode* root);

/// The graph as Inventor text (VRML97, where it has prototypes), readable by readSceneText. Throws std::runtime_error
/// where a value cannot be written and read back (NaN, infinity), naming node and field.
std::string writeSceneText(SoNode* root);

}  // namespace haptiv
