#include "app/bench/wall/WallTrial.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "device/simulated/ScriptedHand.h"
#include "device/simulated/SimulatedDevice.h"
#include "haptics/servo/ServeTick.h"

namespace haptiv {
namespace {

constexpr double kSeconds = 2.0;                      // the approach takes 0.3
constexpr double kFirstLook = 1.2, kLastLook = 1.75;  // [s]
constexpr double kReach = 0.3;                        // [s]
constexpr double kRadius = 0.01;                      // of the ball [m]
constexpr double kThickness = 0.1;                    // [m]

constexpr double kWindow = 0.25;  // [s]
constexpr double kFalls = 0.75;
constexpr double kVeryCalm = 0.25;  // of kCalm

/// Peak to peak about the straight line that fits best: a force that creeps does not oscillate.
double oscillationOf(const std::vector<double>& values) {
  const double middle = 0.5 * static_cast<double>(values.size() - 1);
  double sum = 0, moment = 0, inertia = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double from = static_cast<double>(i) - middle;
    sum += values[i];
    moment += from * values[i];
    inertia += from * from;
  }
  const double mean = sum / static_cast<double>(values.size()), slope = moment / inertia;
  double low = INFINITY, high = -INFINITY;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double off = values[i] - mean - slope * (static_cast<double>(i) - middle);
    low = std::min(low, off);
    high = std::max(high, off);
  }
  return high - low;
}

/// The forces in a stretch of time.
struct Window {
  double from;
  std::vector<double> hand{}, wall{};
  void see(double time, const TickRecord& record) {
    if (time < from || time >= from + kWindow) return;
    hand.push_back(record.handForce.x());
    wall.push_back(record.environmentForce.x());
  }
  double oscillation() const { return std::max(oscillationOf(hand), oscillationOf(wall)); }
};

}  // namespace

const char* nameOf(WallVariant variant) {
  switch (variant) {
    case WallVariant::law:
      return "law";
    case WallVariant::hysteresis:
      return "hysteresis";
    case WallVariant::bothWays:
      return "both-ways";
    case WallVariant::passivity:
      return "passivity";
  }
  return "unknown";
}

WallTouch::WallTouch(DeviceDescription description, double rate)
    : description_(std::move(description)), rate_(rate), tick_(description_, 1 / rate) {}

/// The wall stands across B's x axis, before the arm at home; W is B.
HapticScene WallTouch::sceneOf(const WallTrial& trial) const {
  const Vector3 home = ArmKinematics(description_).forward(description_.homeAngles).position;
  Wall wall;
  wall.id = 1;
  wall.shape.centre = home + Vector3(kApproach + kRadius + kThickness / 2, 0, 0);
  wall.shape.axes = Vector3(kThickness / 2, 0.2, 0.2).asDiagonal();
  wall.surface.stiffness = trial.stiffness;
  wall.surface.damping = trial.damping;
  if (trial.variant == WallVariant::hysteresis) wall.surface.hysteresis = 0.2 * trial.grip.press / trial.stiffness;
  wall.surface.dampsOutwards = trial.variant == WallVariant::bothWays;
  HapticScene scene;
  scene.walls = {wall};
  scene.tool.mass = kMass;
  scene.tool.radius = kRadius;
  scene.tool.home = home;
  scene.control = description_.control.choice;
  scene.control->passivity = trial.variant == WallVariant::passivity;
  computeBounds(scene);
  return scene;
}

WallOutcome WallTouch::operator()(const WallTrial& trial) const {
  const HapticScene scene = sceneOf(trial);
  DeviceDescription description = description_;
  description.hand.stiffness = trial.grip.stiffness;
  description.hand.damping = trial.grip.damping;
  const double beyond = kApproach + trial.grip.press * (1 / trial.grip.stiffness + 1 / trial.stiffness);
  const Vector3 goal = scene.tool.home + Vector3(beyond, 0, 0);
  SimulatedDevice device(
      description, description.homeAngles,
      std::make_unique<ScriptedHand>(std::vector<HandWaypoint>{{0, scene.tool.home}, {kReach, goal}}), trial.seed);
  device.start(1 / rate_);
  TickState state;
  WallOutcome outcome;
  Window first{kFirstLook}, last{kLastLook};
  bool held = true, calm = false;
  const auto end = static_cast<std::uint64_t>(kSeconds * rate_);
  const auto looked = static_cast<std::uint64_t>((kFirstLook + kWindow) * rate_);
  for (; held && !calm && outcome.ticks < end; ++outcome.ticks) {
    const TickRecord record = serveTick(
        device, tick_, [&]() noexcept -> const HapticScene& { return scene; }, state);
    const double time = static_cast<double>(outcome.ticks) / rate_;
    held = record.faults == kNoFault && (time < kLastLook || record.contacts > 0);
    first.see(time, record);
    last.see(time, record);
    calm = outcome.ticks + 1 == looked && record.contacts > 0 && first.oscillation() <= kVeryCalm * kCalm;
  }
  device.stop();
  outcome.oscillation = held ? (calm ? first : last).oscillation() : INFINITY;
  outcome.isStable = held && (outcome.oscillation <= kCalm || outcome.oscillation < kFalls * first.oscillation());
  return outcome;
}

}  // namespace haptiv
