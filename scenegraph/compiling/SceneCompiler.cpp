#include "scenegraph/compiling/SceneCompiler.h"

#include "scenegraph/compiling/SceneCollector.h"

namespace haptiv {

CompiledScene SceneCompiler::compile(SoNode* root, const std::unordered_map<const SoNode*, int>& lineOf,
                                     const std::string& file) {
  SceneCollector collected(memory_, progress_);
  collected.collect(root);

  CompiledScene compiled;
  compiled.diagnostics = std::move(collected.diagnostics);
  locate(compiled.diagnostics, lineOf, file);

  ++version_;
  if (hasErrors(compiled.diagnostics)) {
    memory_.separators.forget();
    return compiled;
  }
  collected.scene.version = version_;
  if (memory_.scene) {
    memory_.indexer.index(collected.scene, *memory_.scene, collected.keptWalls, collected.keptZones);
  } else {
    memory_.indexer.index(collected.scene);
  }
  compiled.scene = memory_.scene = std::make_shared<const HapticScene>(std::move(collected.scene));
  compiled.origins = std::move(collected.origins);
  return compiled;
}

CompiledScene SceneCompiler::compile(const SceneFile& file) {
  CompiledScene compiled = compile(file.root.get());
  for (Diagnostic& diagnostic : compiled.diagnostics) locate(diagnostic, file);
  return compiled;
}

}  // namespace haptiv
