#pragma once

#include <filesystem>
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
};

/// Looks for all that makes Coin crash, hang, open other files or stay silent: unbalanced brackets, text that is no
/// node, nesting deeper than 256, nodes inside themselves (DEF A Separator { USE A }), `fields` that a known node does
/// not have, File, Inline, NURBS and PROTO, textures outside of `folder`. Needs initSceneGraph().
SceneScan scanSceneText(std::string_view text, const std::string& file, const std::filesystem::path& folder);

}  // namespace haptiv
