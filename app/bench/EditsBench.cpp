#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTranslation.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "app/bench/Benches.h"
#include "app/bench/TemporaryLog.h"
#include "app/bench/measuring/BareTimer.h"
#include "app/bench/measuring/MemoryPeak.h"
#include "app/bench/measuring/ThreadCounters.h"
#include "app/bench/scenes/ArmOnFloor.h"
#include "app/bench/scenes/SceneText.h"
#include "app/session/Session.h"
#include "scenegraph/compiling/SceneCompiler.h"
#include "scenegraph/nodes/SoHapticSurface.h"
#include "scenegraph/reading/SceneFile.h"

namespace haptiv {
namespace {

using Clock = std::chrono::steady_clock;

/// How a floor of walls is edited.
struct EditPlan {
  std::uint32_t walls;
  int rounds;
  int edits;                       ///< in a round
  std::chrono::milliseconds pace;  ///< from one to the next
};
constexpr EditPlan kFewWalls{1000, 10, 250, std::chrono::milliseconds(8)};      // two in a graphics frame
constexpr EditPlan kManyWalls{100000, 10, 2, std::chrono::milliseconds(1000)};  // as many as the log can take
/// By then the flight recorder, which keeps two seconds, has forgotten the scenes of the edits.
constexpr std::chrono::milliseconds kPause{2200};

/// A floor of walls as a scene graph, whose walls are stiffened, moved, taken away and put back, in turn.
class EditedFloor {
 public:
  explicit EditedFloor(std::uint32_t walls) : walls_(walls), arm_(walls), text_(sceneText(arm_.scene())) {
    file_ = readSceneText(text_.get(), "bench.iv");
    if (!file_.root) throw std::runtime_error("the bench's own scene cannot be read: this is a fault of the program");
  }

  SessionSetup setup(const std::filesystem::path& log) {
    SessionSetup setup;
    setup.scene = compiled();
    setup.sceneText = text_;
    setup.description = arm_.description();
    setup.hand = arm_.hand();
    setup.log = log;
    return setup;
  }

  void edit(int number) {
    SoSeparator& root = *file_.root.get();
    const int at = 2 + 7 * (number / 4) % static_cast<int>(walls_ - 8);  // after device and tool
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

  const SharedText& text() const { return text_; }

  std::shared_ptr<const HapticScene> compiled() {
    CompiledScene result = compiler_.compile(file_);
    if (!result.scene)
      throw std::runtime_error("the bench's own scene does not compile: this is a fault of the program");
    return std::move(result.scene);
  }

 private:
  std::uint32_t walls_;
  ArmOnFloor arm_;
  SharedText text_;
  SceneFile file_;
  SceneCompiler compiler_;
  NodeRef<SoSeparator> taken_;
};

/// What has come of the deadlines of some time.
struct Deadlines {
  double ticks = 0, missed = 0;              ///< of the servo
  double floorTicks = 0, floorMissed = 0;    ///< of a thread that does nothing but wait for them
  double pageFaults = 0, interruptions = 0;  ///< of the servo's thread, as Linux counts them

  void addTo(std::vector<std::pair<std::string, double>>& notes, const std::string& when) const {
    notes.insert(notes.end(), {{"ticks" + when, ticks},
                               {"missed_ticks" + when, missed},
                               {"floor_ticks" + when, floorTicks},
                               {"floor_missed_ticks" + when, floorMissed},
                               {"servo_page_faults" + when, pageFaults},
                               {"servo_interruptions" + when, interruptions}});
  }
};

/// Counts deadlines from one look to the next. Made while the session's servo is the only realtime thread.
class DeadlineWatch {
 public:
  explicit DeadlineWatch(Session& session) : session_(session), servo_(realtimeThread()), floor_(ServoPace()) {
    lookAway();
  }
  /// What has been since the last look is added to `sum`.
  void look(Deadlines& sum) {
    const Deadlines before = last_;
    lookAway();
    sum.ticks += last_.ticks - before.ticks;
    sum.missed += last_.missed - before.missed;
    sum.floorTicks += last_.floorTicks - before.floorTicks;
    sum.floorMissed += last_.floorMissed - before.floorMissed;
    sum.pageFaults += last_.pageFaults - before.pageFaults;
    sum.interruptions += last_.interruptions - before.interruptions;
  }
  /// What has been since the last look goes nowhere.
  void lookAway() {
    TickRecord newest;
    while (!session_.newest(newest)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const ThreadCounters servo = servo_ ? countersOf(*servo_).value_or(ThreadCounters()) : ThreadCounters();
    const auto number = [](std::uint64_t count) { return static_cast<double>(count); };
    last_ = {number(newest.tick),     number(newest.missedTicks), number(floor_.ticks()),
             number(floor_.missed()), number(servo.pageFaults),   number(servo.interruptions)};
  }

 private:
  Session& session_;
  std::optional<int> servo_;
  BareTimer floor_;
  Deadlines last_;
};

void benchPlan(BenchRun& run, const EditPlan& plan) {
  run.tell("edits: " + std::to_string(plan.rounds * plan.edits) + " of a running session among " +
           std::to_string(plan.walls) + " walls");
  EditedFloor floor(plan.walls);
  const TemporaryLog log;
  Session session(floor.setup(log.path()));
  DeadlineWatch watch(session);
  CallTimes times(static_cast<std::size_t>(plan.edits));
  Deadlines edited, idle;
  std::vector<std::optional<double>> held;  // after each pause; by the second one the heap has found its size
  for (int round = 0; round < plan.rounds; ++round) {
    Clock::time_point next = Clock::now();
    for (int i = 0; i < plan.edits; ++i) {
      floor.edit(round * plan.edits + i);
      times.time([&] { return session.publish(floor.compiled(), floor.text()).get(); });
      std::this_thread::sleep_until(next += plan.pace);
    }
    times.endPass();
    watch.look(edited);
    std::this_thread::sleep_for(kPause);
    watch.look(idle);
    held.push_back(memoryHeld());  // gives back what is free, which is the bench's own doing, not an edit's
    watch.lookAway();
  }
  const std::string trouble = session.logTrouble();
  session.stop();
  if (!trouble.empty()) throw std::runtime_error("the log of the bench's session failed: " + trouble);
  BenchResult result = resultOf("edits/live", plan.walls, times);
  edited.addTo(result.notes, "");
  idle.addTo(result.notes, "_without_edits");
  if (held[1] && held.back()) result.notes.emplace_back("memory_growth_MiB", *held.back() - *held[1]);
  run.add(result);
}

}  // namespace

void benchEdits(BenchRun& run) {
  benchPlan(run, kFewWalls);
  benchPlan(run, kManyWalls);
}

}  // namespace haptiv
