#include "scenegraph/SceneCompiler.h"

#include <Inventor/SoPath.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>

#include <algorithm>

#include "haptics/ShapeDistance.h"
#include "scenegraph/compiling/SceneCollector.h"
#include "scenegraph/nodes/SoHapticTool.h"

namespace haptiv {
namespace {

/// The nodes on the way to a shape. A group may hold one node twice, and an array visits it often: the caller counts.
std::vector<const void*> nodesOf(const SoPath& path) {
  const auto* full = static_cast<const SoFullPath*>(&path);
  std::vector<const void*> nodes;
  for (int i = 0; i < full->getLength(); ++i) nodes.push_back(full->getNode(i));
  return nodes;
}

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

CompiledScene SceneCompiler::compile(SoNode* root, const std::unordered_map<const SoNode*, int>& lineOf,
                                     const std::string& file) {
  std::map<PathKey, std::uintptr_t> timesMet;
  SceneCollector collected([&](const SoPath& path) {
    PathKey key = nodesOf(path);
    const std::uintptr_t time = timesMet[key]++;
    key.push_back(reinterpret_cast<const void*>(time));
    return ids_.try_emplace(key, static_cast<ShapeId>(ids_.size() + 1)).first->second;
  });
  collected.collect(root);
  if (!hasErrors(collected.diagnostics)) warnOfHomeInWall(collected);

  CompiledScene compiled;
  compiled.diagnostics = std::move(collected.diagnostics);
  for (Diagnostic& diagnostic : compiled.diagnostics) {
    diagnostic.file = file;
    const auto line = lineOf.find(diagnostic.source);
    if (line != lineOf.end()) diagnostic.line = line->second;
  }
  SoGetPrimitiveCountAction count;
  count.apply(root);
  compiled.triangles = static_cast<std::size_t>(std::max(0, count.getTriangleCount()));

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
