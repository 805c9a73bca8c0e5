#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "haptics/scene/HapticScene.h"
#include "scenegraph/Diagnostic.h"
#include "scenegraph/compiling/SceneMemory.h"
#include "scenegraph/compiling/ShapeOrigin.h"
#include "scenegraph/reading/SceneFile.h"

namespace haptiv {

/// What a scene graph came to.
struct CompiledScene {
  std::shared_ptr<const HapticScene> scene;  ///< null where there are errors
  SceneOrigins origins;                      ///< of what is in `scene`
  Diagnostics diagnostics;
};

/// Told while a long compilation goes on: how many shapes and triangles have been gathered.
using CompileProgress = std::function<void(std::size_t shapes, std::size_t triangles)>;

/// Turns a scene graph into what the servo feels. Keep one for the life of a document: it remembers which id a shape
/// had, so that the tool's contact with a wall survives an edit, and what an edit has not touched is not read and not
/// indexed anew. What comes out is the same as when everything is. Thread: GUI.
class SceneCompiler {
 public:
  /// @param lineOf, file  for diagnostics only; nodes made in the editor are not in it
  CompiledScene compile(SoNode* root, const std::unordered_map<const SoNode*, int>& lineOf = {},
                        const std::string& file = {});

  /// Of a whole file, whose nodes may stand in others that it includes.
  CompiledScene compile(const SceneFile& file);

  /// From now on, calls this a few times a second while it compiles; small scenes are done before the first call.
  void setProgress(CompileProgress progress) { progress_ = std::move(progress); }

 private:
  SceneMemory memory_;
  CompileProgress progress_;
  std::uint32_t version_ = 0;
};

}  // namespace haptiv
