#include <Inventor/actions/SoSearchAction.h>

#include <stdexcept>

#include "app/bench/Benches.h"
#include "app/bench/MemoryPeak.h"
#include "app/bench/SceneText.h"
#include "app/bench/collision/WallFloor.h"
#include "scenegraph/SceneCompiler.h"
#include "scenegraph/SceneFile.h"
#include "scenegraph/nodes/SoHapticSurface.h"

namespace haptiv {
namespace {

constexpr int kReads = 3;
constexpr int kCompilations = 7;
constexpr int kEdits = 50;

std::shared_ptr<const HapticScene> compiled(SceneCompiler& compiler, const SceneFile& file) {
  CompiledScene result = compiler.compile(file.root.get(), file.lineOf, file.path);
  if (!result.scene) throw std::runtime_error("the bench's own scene does not compile: this is a fault of the program");
  return std::move(result.scene);
}

SceneFile read(const std::string& text) {
  SceneFile file = readSceneText(text, "bench.iv");
  if (!file.root) throw std::runtime_error("the bench's own scene cannot be read: this is a fault of the program");
  return file;
}

/// Every compilation is a first one; the memory is what the very first one adds.
void benchFirst(BenchRun& run, std::uint32_t walls) {
  run.tell("compile: " + std::to_string(walls) + " walls");
  const std::string text = sceneText(WallFloor(walls, 1).scene());
  CallTimes reading(1), compiling(1);
  SceneFile file;
  for (int i = 0; i < kReads; ++i) {
    file = {};
    file = reading.time([&] { return read(text); });
    reading.endPass();
  }
  std::optional<double> grown;
  for (int i = 0; i < kCompilations; ++i) {
    const MemoryPeak memory;
    SceneCompiler compiler;
    const auto scene = compiling.time([&] { return compiled(compiler, file); });
    compiling.endPass();
    if (i == 0) grown = memory.grownBy();
  }
  run.add(resultOf("compile/read", walls, reading));
  BenchResult result = resultOf("compile/walls", walls, compiling);
  if (grown) result.notes = {{"extra_memory_MiB", *grown}};
  run.add(result);
}

/// A field changes, and the scene is compiled again: what an edit costs between two frames.
void benchEdit(BenchRun& run, std::uint32_t walls) {
  run.tell("compile: edits among " + std::to_string(walls) + " walls");
  const SceneFile file = read(sceneText(WallFloor(walls, 1).scene()));
  SoSearchAction search;
  search.setType(SoHapticSurface::getClassTypeId());
  search.setInterest(SoSearchAction::LAST);
  search.apply(file.root.get());
  auto* surface = static_cast<SoHapticSurface*>(search.getPath()->getTail());
  SceneCompiler compiler;
  std::shared_ptr<const HapticScene> scene = compiled(compiler, file);
  CallTimes edits(kEdits);
  for (int i = 0; i < kEdits; ++i) {
    surface->stiffness = 1000.0F + static_cast<float>(i);
    edits.time([&] {
      scene = compiled(compiler, file);  // the one before is destroyed here too
      return scene.get();
    });
  }
  edits.endPass();
  run.add(resultOf("compile/edit", walls, edits));
}

}  // namespace

void benchCompile(BenchRun& run) {
  benchFirst(run, 100000);
  benchEdit(run, 10000);
}

}  // namespace haptiv
