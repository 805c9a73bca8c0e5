#pragma once

#include <Inventor/nodes/SoSeparator.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>

#include "scenegraph/DecodePicture.h"
#include "scenegraph/Diagnostic.h"
#include "scenegraph/NodeRef.h"

namespace haptiv {

/// A scene as it was read: the graph, its text, and on which line each node stands.
struct SceneFile {
  std::string path;                               ///< as the user named it
  std::string text;                               ///< all of it, unpacked; of a binary file: as Coin writes it as text
  NodeRef<SoSeparator> root;                      ///< null where the diagnostics hold an error
  std::unordered_map<const SoNode*, int> lineOf;  ///< 1-based; a binary file has no lines
  std::unordered_map<const SoNode*, std::string> fileOf;  ///< where it is another file, which the scene includes
  Diagnostics diagnostics;
};

/// Says on which line of which file a diagnostic's source stands.
void locate(Diagnostic& diagnostic, const SceneFile& scene);
/// The scene now stands in this file as this text, which was written of its graph: finds the lines anew.
void moveTo(const std::filesystem::path& path, const std::string& text, SceneFile& scene);

/// Makes Coin and the haptic nodes ready; call once, before anything else here, on the GUI thread, after SoQt::init
/// where there is a window.
void initSceneGraph();

/// Reads a scene; the file may be hostile. Never throws; what is wrong stands in the diagnostics.
/// @param decode  for textures; empty: Coin reads them, where it can
SceneFile readScene(const std::filesystem::path& path, const DecodePicture& decode = {});
/// The same from memory. `name` stands for the path in diagnostics.
SceneFile readSceneText(std::string_view text, const std::string& name);

/// Judges a graph whose fields have been changed as readScene judges what it has read: indices, sizes. The diagnostics
/// become those of that.
void judgeAgain(SceneFile& scene);

}  // namespace haptiv
