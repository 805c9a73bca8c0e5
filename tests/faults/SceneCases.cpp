#include <limits>

#include "tests/faults/FaultCases.h"

namespace haptiv::faults {
namespace {

using Chain = FaultChain;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The operator presses on the wall; at the injection the scene is edited.
template <typename Edit>
Chain::Script edited(Edit edit) {
  return [edit](Chain& chain, int since) {
    pressOnWall(chain);
    if (since != 0) return;
    ++chain.scene.version;
    edit(chain.scene);
  };
}

/// Before the start the scene is made so; then the hand does as `carry` says.
template <typename Make, typename Carry>
Chain::Script madeSo(Make make, Carry carry) {
  return [=](Chain& chain, int since) {
    if (chain.time() == 0) make(chain.scene);
    carry(chain, since);
  };
}

/// The hand jerks the ball along y as hard as it can.
void jerk(Chain& chain, int since) {
  chain.hand.target.holding = true;
  chain.hand.target.position = chain.home() + Vector3(0, since < 0 ? -0.3 : 0.6, 0);
}
/// The same, but for a hand that lets go when the arm has stopped.
void jerkAndLetGo(Chain& chain, int since) {
  jerk(chain, since);
  if (since > 300) chain.hand.target.holding = false;
}
/// The hand throws the ball at the wall as hard as it can.
void thrust(Chain& chain, int since) {
  chain.hand.target.holding = true;
  chain.hand.target.position = chain.home() + Vector3(since < 0 ? -0.2 : 0.3, 0, 0);
}
void press(Chain& chain, int) {
  pressOnWall(chain);
}
/// The hand has let go; at the injection it gives the ball a push of a tenth of a second.
void nudge(Chain& chain, int since) {
  chain.hand.target.holding = since >= 0 && since < 100;
  chain.hand.target.position = chain.home() + Vector3(0, 0.05, 0);
}

}  // namespace

FaultGroup sceneFaults() {
  const auto running = SessionState::running;
  return {"The scene",
          {{"a stiffness that is no number", kFaultNotFinite, kNoClamp, SessionState::fault, 1,
            edited([](HapticScene& scene) { scene.walls[0].surface.stiffness = kNan; })},
           {"a ball without mass", kFaultNotFinite, kNoClamp, SessionState::fault, 1,
            edited([](HapticScene& scene) { scene.tool.mass = 0; })},
           {"a place of the device that is no number", kFaultNotFinite, kNoClamp, SessionState::fault, 1,
            edited([](HapticScene& scene) { scene.device.position.x() = kNan; })},
           {"swapped in contact: the wall is gone", kNoFault, kNoClamp, running, 0,
            edited([](HapticScene& scene) { scene.walls.clear(); })},
           {"swapped in contact: the wall stands 50 mm nearer", kNoFault, kNoClamp, running, 0,
            edited([](HapticScene& scene) { scene.walls[0].shape.centre.x() -= 0.05; })},
           {"swapped in contact: the wall is three times as stiff", kNoFault, kNoClamp, running, 0,
            edited([](HapticScene& scene) { scene.walls[0].surface.stiffness *= 3; })}}};
}

FaultGroup clampCases() {
  const auto running = SessionState::running;
  const auto nothing = [](HapticScene& scene) { scene.walls.clear(); };
  return {
      "Clamps",
      {{"the ball is thrown into a wall of 40,000 N/m", kNoFault, kClampForce, running, 0,
        madeSo([](HapticScene& scene) { scene.walls[0].surface.stiffness = 4e4; }, thrust)},
       {"the hand pulls a light ball with 170 N", kNoFault, kClampSpeed | kClampAcceleration, running, 0,
        madeSo(
            [](HapticScene& scene) {
              scene.walls.clear();
              scene.tool.mass = 0.5;
            },
            jerk)},
       {"the same under computed torque", kNoFault, kClampSpeed | kClampAcceleration, running, 0, madeSo(nothing, jerk),
        1, 0.5, [](Chain& chain) { chain.description.control.choice.joints = JointController::computedTorque; }},
       {"the hand drives the bare arm with 170 N, impedance display", kFaultToolSpeed, kNoClamp, SessionState::fault,
        500, madeSo(nothing, jerkAndLetGo), 1, 1,
        [](Chain& chain) { chain.description.control.choice.display = DisplayMode::impedance; }},
       {"joints near their rate limits", kNoFault, kClampJointRate, running, 0, jerk, 1, 0.5,
        [](Chain& chain) { chain.description.drives.rateLimit.setConstant(1.2); }}}};
}

FaultGroup stabilityFaults() {
  return {"Stability",
          {{"runaway admittance: a medium that pushes (-10 N s/m), nobody holds the ball", kFaultRunaway, kClampSpeed,
            SessionState::fault, 1000,
            madeSo(
                [](HapticScene& scene) {
                  scene.walls.clear();
                  scene.tool.damping = -10;
                },
                nudge),
            1, 1.2},
           {"oscillation: a wall of 20,000,000 N/m", kFaultOscillation, kClampForce, SessionState::fault, 1000,
            madeSo([](HapticScene& scene) { scene.walls[0].surface.stiffness = 2e7; }, press), 0.01, 1.5},
           {"oscillation: a ball of 20 g in a firm grip", kFaultOscillation, kNoClamp, SessionState::fault, 1500,
            madeSo(
                [](HapticScene& scene) {
                  scene.tool.mass = 0.02;
                  scene.tool.damping = 0.1;
                },
                press),
            0.01, 1.5}}};
}

}  // namespace haptiv::faults
