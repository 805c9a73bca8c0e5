#pragma once

#include <memory>
#include <string>

#include "device/described/DeviceDescription.h"
#include "haptics/scene/HapticScene.h"
#include "scenegraph/compiling/SceneCompiler.h"
#include "scenegraph/reading/SceneFile.h"

namespace haptiv {

/// A scene as a session needs it: read, compiled, and its device found.
struct LoadedScene {
  SceneFile file;
  CompiledScene compiled;
  DeviceDescription device;
  Diagnostics diagnostics;  ///< of all steps
};

/// How a scene is loaded.
struct LoadOptions {
  bool solid = false;  ///< a file that is only seen becomes something to feel
  double rate = 1000;  ///< at which it is to be felt [Hz]
};

/// Reads and judges a scene; what is wrong with it stands in the diagnostics. Needs initSceneGraph.
/// Throws CommandFailure (kCouldNot) where the file cannot be read at all.
LoadedScene loadScene(const std::string& path, const LoadOptions& options = {});

/// Errors and warnings as lines on stderr.
void tell(const Diagnostics& diagnostics);

}  // namespace haptiv
