#pragma once

#include <cstddef>
#include <vector>

class SoField;
class SoFieldContainer;
class SoNode;

namespace haptiv {

/// The fields of a node or an engine, in the order in which it declares them.
std::vector<SoField*> fieldsOf(const SoFieldContainer* container);

/// The nodes right below a node that stand in its text: children of a group, and nodes held by fields.
std::vector<SoNode*> writtenChildren(const SoNode* node);

/// The nodes right below a node that actions visit: hidden children too.
std::vector<SoNode*> traversedChildren(const SoNode* node);

/// Every node that stands in the text of a graph, once, in the order of the text.
std::vector<SoNode*> writtenNodes(SoNode* root);

/// How many triangles Coin draws of a scene graph. Thread: GUI.
std::size_t drawnTriangles(SoNode* root);

}  // namespace haptiv
