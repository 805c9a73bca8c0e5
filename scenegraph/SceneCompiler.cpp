#include "scenegraph/SceneCompiler.h"

#include <Inventor/actions/SoGetPrimitiveCountAction.h>

#include <algorithm>

#include "haptics/ShapeDistance.h"
#include "scenegraph/compiling/SceneCollector.h"
#include "scenegraph/nodes/SoHapticTool.h"

namespace haptiv {
namespace {

/// A session that starts in a wall is no mistake of the file's, yet hardly meant.
void warnOfHomeInWall(SceneCollector& collected) {
  const Tool& tool = collected.scene.tool;
  for (const Wall& wall : collected.scene.walls) {
    if (nearestSurface(wall.shape, tool.home).distance >= tool.radius) continue;
    collected.diagnostics.push_back({Diagnostic::Severity::warning,
                                     {},
                                     0,
                                     "HapticTool",
                                     "its home is inside a wall: move home into free space",
                                     collected.tool()});
    return;
  }
}

}  // namespace

std::size_t drawnTriangles(SoNode* root) {
  SoGetPrimitiveCountAction count;
  count.apply(root);
  return static_cast<std::size_t>(std::max(0, count.getTriangleCount()));
}

CompiledScene SceneCompiler::compile(SoNode* root, const std::unordered_map<const SoNode*, int>& lineOf,
                                     const std::string& file) {
  ids_.begin();
  SceneCollector collected([this](const SoPath& path) { return ids_.idOf(path); });
  collected.collect(root);
  if (!hasErrors(collected.diagnostics)) warnOfHomeInWall(collected);

  CompiledScene compiled;
  compiled.diagnostics = std::move(collected.diagnostics);
  for (Diagnostic& diagnostic : compiled.diagnostics) {
    diagnostic.file = file;
    const auto line = lineOf.find(diagnostic.source);
    if (line != lineOf.end()) diagnostic.line = line->second;
  }

  ++version_;
  if (!hasErrors(compiled.diagnostics)) {
    collected.scene.version = version_;
    computeBounds(collected.scene);
    compiled.scene = std::make_shared<const HapticScene>(std::move(collected.scene));
  }
  return compiled;
}

CompiledScene SceneCompiler::compile(const SceneFile& file) {
  CompiledScene compiled = compile(file.root.get());
  for (Diagnostic& diagnostic : compiled.diagnostics) locate(diagnostic, file);
  return compiled;
}

}  // namespace haptiv
