#include "app/commands/LoadedScene.h"

#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "app/commands/ExitCode.h"
#include "haptics/SessionStart.h"
#include "scenegraph/nodes/SoHapticDevice.h"
#include "scenegraph/nodes/SoHapticTool.h"

namespace haptiv {
namespace {

// Where the scene's node of this type stands; 0: nowhere, the default is in force.
template <typename Node>
int lineOf(const SceneFile& file) {
  for (const auto& [node, line] : file.lineOf) {
    if (node->isOfType(Node::getClassTypeId())) return line;
  }
  return 0;
}

void judgeDevice(LoadedScene& loaded) {
  const auto complain = [&loaded](int line, const char* node, const std::string& message) {
    loaded.diagnostics.push_back({Diagnostic::Severity::error, loaded.file.path, line, node, message, nullptr});
  };
  const HapticScene& scene = *loaded.compiled.scene;
  try {
    loaded.device = loadDeviceDescription(scene.device.description);
  } catch (const std::exception& error) {
    complain(lineOf<SoHapticDevice>(loaded.file), "HapticDevice", error.what());
    return;
  }
  if (!sessionStart(scene, loaded.device).inReach())
    complain(lineOf<SoHapticTool>(loaded.file), "HapticTool",
             "home is out of the arm's reach; move it, or the HapticDevice, or raise the device's scale");
}

}  // namespace

LoadedScene loadScene(const std::string& path) {
  requireReadable(path);
  LoadedScene loaded;
  loaded.file = readScene(path);
  loaded.diagnostics = loaded.file.diagnostics;
  if (!loaded.file.root) return loaded;
  SceneCompiler compiler;
  loaded.compiled = compiler.compile(loaded.file);
  const Diagnostics& found = loaded.compiled.diagnostics;
  loaded.diagnostics.insert(loaded.diagnostics.end(), found.begin(), found.end());
  if (loaded.compiled.scene) judgeDevice(loaded);
  return loaded;
}

void tell(const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics) std::cerr << toText(diagnostic) << "\n";
}

void requireReadable(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw CommandFailure(kCouldNot, path + ": this is a folder; name a file in it");
  if (!std::ifstream(path))
    throw CommandFailure(kCouldNot, path + ": cannot be read: " + std::strerror(errno) + "; check the path");
}

}  // namespace haptiv
