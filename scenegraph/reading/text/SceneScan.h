#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scenegraph/Diagnostic.h"

namespace haptiv {

/// A node as it stands in the text, the USE of one, or the declaration of a prototype.
struct TextNode {
  static constexpr std::size_t kNone = ~std::size_t{0};

  std::string keyword;  ///< empty: a USE; of a prototype PROTO or EXTERNPROTO
  std::string name;     ///< DEF, or the prototype's
  int line = 0;
  int lastLine = 0;            ///< where it is closed
  std::size_t parent = kNone;  ///< the node that it stands in
  std::string_view field;      ///< the word before it, or before the list that it stands in: its field, if it is in one
  bool isApart = false;        ///< in a prototype, or what a field is connected to: no child of its parent

  bool isNode() const { return !keyword.empty() && keyword != "PROTO" && keyword != "EXTERNPROTO"; }
};

/// What a scene's text shows before Coin reads it. It points into the text.
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
