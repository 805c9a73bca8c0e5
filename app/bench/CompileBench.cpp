#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTranslation.h>

#include <stdexcept>

#include "app/bench/Benches.h"
#include "app/bench/measuring/MemoryPeak.h"
#include "app/bench/scenes/SceneText.h"
#include "app/bench/scenes/WallFloor.h"
#include "scenegraph/compiling/SceneCompiler.h"
#include "scenegraph/nodes/SoHapticSurface.h"
#include "scenegraph/reading/SceneFile.h"

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

/// The floor's walls are Separators of a property, a place and a Cube, after device and tool.
class EditedWalls {
 public:
  explicit EditedWalls(std::uint32_t walls) : file_(read(sceneText(WallFloor(walls, 1).scene()))), walls_(walls) {}

  void stiffen(int number) {
    static_cast<SoHapticSurface*>(wall(number)->getChild(0))->stiffness = 1000.0F + static_cast<float>(number);
  }
  void move(int number) {
    auto* place = static_cast<SoTranslation*>(wall(number)->getChild(1));
    place->translation = place->translation.getValue() + SbVec3f(0.003F, 0, 0.001F);
  }
  void resize(int number) {
    auto* cube = static_cast<SoCube*>(wall(number)->getChild(2));
    cube->width = 0.9F * cube->width.getValue();
  }
  void remove(int number) {
    taken_ = NodeRef<SoSeparator>(wall(number));
    file_.root->removeChild(at(number));
  }
  void putBack(int number) { file_.root->insertChild(taken_.get(), at(number)); }

  const SceneFile& file() const { return file_; }

 private:
  int at(int number) const { return 2 + static_cast<int>((7919U * static_cast<std::uint32_t>(number)) % (walls_ - 8)); }
  SoSeparator* wall(int number) { return static_cast<SoSeparator*>(file_.root->getChild(at(number))); }

  SceneFile file_;
  std::uint32_t walls_;
  NodeRef<SoSeparator> taken_;
};

/// Something of a wall changes, and the scene is compiled again: what an edit costs between two frames.
void benchEditsAmong(BenchRun& run, std::uint32_t walls) {
  run.tell("compile: edits among " + std::to_string(walls) + " walls");
  EditedWalls edited(walls);
  SceneCompiler compiler;
  std::shared_ptr<const HapticScene> scene = compiled(compiler, edited.file());
  const auto bench = [&](const std::string& name, auto&& edit) {
    CallTimes times(kEdits);
    for (int i = 0; i < kEdits; ++i) {
      edit(i, [&] {
        times.time([&] {
          scene = compiled(compiler, edited.file());  // the one before is destroyed here too
          return scene.get();
        });
      });
    }
    times.endPass();
    run.add(resultOf(name, walls, times));
  };
  const auto after = [&](auto change) {
    return [&edited, change](int i, auto&& compile) {
      (edited.*change)(i);
      compile();
    };
  };
  bench("compile/edit", after(&EditedWalls::stiffen));
  bench("compile/edit/move", after(&EditedWalls::move));
  bench("compile/edit/size", after(&EditedWalls::resize));
  bench("compile/edit/remove", [&](int i, auto&& compile) {
    edited.remove(i);
    compile();
    edited.putBack(i);
    scene = compiled(compiler, edited.file());
  });
  bench("compile/edit/add", [&](int i, auto&& compile) {
    edited.remove(i);
    scene = compiled(compiler, edited.file());
    edited.putBack(i);
    compile();
  });
}

}  // namespace

void benchCompile(BenchRun& run) {
  benchFirst(run, 100000);
  benchEditsAmong(run, 10000);
  benchEditsAmong(run, 100000);
}

}  // namespace haptiv
