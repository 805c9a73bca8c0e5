#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTranslation.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "app/bench/ArmOnFloor.h"
#include "app/bench/Benches.h"
#include "app/bench/MemoryPeak.h"
#include "app/bench/SceneText.h"
#include "app/bench/TemporaryFile.h"
#include "app/session/Session.h"
#include "scenegraph/SceneCompiler.h"
#include "scenegraph/SceneFile.h"
#include "scenegraph/nodes/SoHapticSurface.h"

namespace haptiv {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kWalls = 1000;
constexpr int kRounds = 10;
constexpr int kEdits = 100;  // in a round
/// At least: by then the flight recorder, which keeps two seconds, has forgotten the scenes of the edits.
constexpr std::chrono::milliseconds kPause{2200};

/// A floor of walls as a scene graph, whose walls are stiffened, moved, taken away and put back, in turn.
class EditedFloor {
 public:
  EditedFloor() : arm_(kWalls) {
    file_ = readSceneText(sceneText(arm_.scene()), "bench.iv");
    if (!file_.root) throw std::runtime_error("the bench's own scene cannot be read: this is a fault of the program");
  }

  SessionSetup setup(const std::filesystem::path& log) {
    SessionSetup setup;
    setup.scene = compiled();
    setup.description = arm_.description();
    setup.hand = arm_.hand();
    setup.log = log;
    return setup;
  }

  void edit(int number) {
    SoSeparator& root = *file_.root.get();
    const int at = 2 + 7 * (number / 4) % static_cast<int>(kWalls - 8);  // after device and tool
    auto* wall = static_cast<SoSeparator*>(root.getChild(at));
    if (number % 4 == 0) static_cast<SoHapticSurface*>(wall->getChild(0))->stiffness = 1000.0F + number % 1000;
    if (number % 4 == 1) {
      auto* place = static_cast<SoTranslation*>(wall->getChild(1));
      place->translation = place->translation.getValue() + SbVec3f(0, 0, 0.001F);
    }
    if (number % 4 == 2) {
      taken_ = NodeRef<SoSeparator>(wall);
      root.removeChild(at);
    }
    if (number % 4 == 3) root.insertChild(taken_.get(), at);
  }

  std::shared_ptr<const HapticScene> compiled() {
    CompiledScene result = compiler_.compile(file_);
    if (!result.scene)
      throw std::runtime_error("the bench's own scene does not compile: this is a fault of the program");
    return std::move(result.scene);
  }

 private:
  ArmOnFloor arm_;
  SceneFile file_;
  SceneCompiler compiler_;
  NodeRef<SoSeparator> taken_;
};

/// Ticks that were to be run and that were missed, from one look to the next.
class MissedTicks {
 public:
  explicit MissedTicks(Session& session) : session_(session) { look(); }
  /// What has been since the last look goes to `ticks` and `missed`.
  void look(double& ticks, double& missed) {
    const TickRecord before = newest_;
    look();
    ticks += static_cast<double>(newest_.tick - before.tick);
    missed += static_cast<double>(newest_.missedTicks - before.missedTicks);
  }
  /// What has been since the last look goes nowhere.
  void look() {
    while (!session_.newest(newest_)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

 private:
  Session& session_;
  TickRecord newest_;
};

}  // namespace

void benchEdits(BenchRun& run) {
  run.tell("edits: " + std::to_string(kRounds * kEdits) + " of a running session");
  EditedFloor floor;
  const TemporaryFile log;
  Session session(floor.setup(log.path()));
  MissedTicks watch(session);
  CallTimes times(kEdits);
  double editedTicks = 0, editedMissed = 0, idleTicks = 0, idleMissed = 0;
  std::vector<std::optional<double>> held;  // after each pause; by the second one the heap has found its size
  for (int round = 0; round < kRounds; ++round) {
    const Clock::time_point begin = Clock::now();
    for (int i = 0; i < kEdits; ++i) {
      floor.edit(round * kEdits + i);
      times.time([&] { return session.publish(floor.compiled(), "bench").get(); });
    }
    times.endPass();
    watch.look(editedTicks, editedMissed);
    std::this_thread::sleep_for(std::max<Clock::duration>(Clock::now() - begin, kPause));
    watch.look(idleTicks, idleMissed);
    held.push_back(memoryHeld());  // gives back what is free, which is the bench's own doing, not an edit's
    watch.look();
  }
  const std::string trouble = session.logTrouble();
  session.stop();
  if (!trouble.empty()) throw std::runtime_error("the log of the bench's session failed: " + trouble);
  BenchResult result = resultOf("edits/live", kWalls, times);
  result.notes = {{"ticks", editedTicks},
                  {"missed_ticks", editedMissed},
                  {"ticks_without_edits", idleTicks},
                  {"missed_ticks_without_edits", idleMissed}};
  if (held[1] && held.back()) result.notes.emplace_back("memory_growth_MiB", *held.back() - *held[1]);
  run.add(result);
}

}  // namespace haptiv
