#include "scenegraph/SceneCompiler.h"

#include <Inventor/actions/SoGetPrimitiveCountAction.h>

#include <algorithm>

#include "haptics/scene/SameShapes.h"
#include "scenegraph/compiling/SceneCollector.h"

namespace haptiv {

std::size_t drawnTriangles(SoNode* root) {
  SoGetPrimitiveCountAction count;
  count.apply(root);
  return static_cast<std::size_t>(std::max(0, count.getTriangleCount()));
}

CompiledScene SceneCompiler::compile(SoNode* root, const std::unordered_map<const SoNode*, int>& lineOf,
                                     const std::string& file) {
  ids_.begin();
  SceneCollector collected(ids_, meshes_, progress_);
  collected.collect(root);

  CompiledScene compiled;
  compiled.diagnostics = std::move(collected.diagnostics);
  locate(compiled.diagnostics, lineOf, file);

  ++version_;
  if (!hasErrors(compiled.diagnostics)) {
    collected.scene.version = version_;
    if (before_) {
      computeBounds(collected.scene, *before_);
    } else {
      computeBounds(collected.scene);
    }
    compiled.scene = before_ = std::make_shared<const HapticScene>(std::move(collected.scene));
    compiled.origins = std::move(collected.origins);
  }
  return compiled;
}

CompiledScene SceneCompiler::compile(const SceneFile& file) {
  CompiledScene compiled = compile(file.root.get());
  for (Diagnostic& diagnostic : compiled.diagnostics) locate(diagnostic, file);
  return compiled;
}

}  // namespace haptiv
