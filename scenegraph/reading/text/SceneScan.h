#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scenegraph/Diagnostic.h"

namespace haptiv {

/// A node as it stands in the text.
struct TextNode {
  std::string keyword;
  std::string name;  ///< DEF
  int line = 0;
};

/// What a scene's text shows before Coin reads it.
struct SceneScan {
  std::vector<TextNode> nodes;  ///< in the order of the text
  Diagnostics diagnostics;
  bool isPlain = true;  ///< only everyday nodes, no connections, and not a word that could be read in two ways
};

/// Looks for all that makes Coin crash, hang or stay silent: unbalanced brackets, text that is no node, nesting deeper
/// than 1000, nodes and prototypes inside themselves (DEF A Separator { USE A }), `fields` that a known node does not
/// have, pictures larger than the file, text after the end. Needs initSceneGraph().
SceneScan scanSceneText(std::string_view text, const std::string& file);

}  // namespace haptiv
