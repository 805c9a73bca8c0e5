#include "haptics/passivity/Passivity.h"

#include <algorithm>

namespace haptiv {
namespace {

/// What the walls' springs hold at most [J]. The force belongs to a place up to a tick's way from where the ball is.
double storedInWalls(const HapticScene& scene, const ContactSet& contacts, double way) noexcept {
  double stored = 0, stiffest = 0;
  for (const Contact& contact : contacts) {
    const double stiffness = scene.walls[static_cast<std::size_t>(contact.wall)].surface.stiffness;
    const double depth = contact.elasticDepth() + way;
    stored += 0.5 * stiffness * depth * depth;
    stiffest = std::max(stiffest, stiffness);
  }
  return stored + 0.5 * stiffest * contacts.frictionOffset.squaredNorm();
}

}  // namespace

Passivity::Passivity(const DeviceDescription& description, double period)
    : inertia_(description.drives.inertia), largestForce_(description.safety.forceClamp), period_(period) {}

/// Not more than the arm's mass at the tool in any direction, of what turns about the joints alone: with
/// J D^-1 J^T = 1/mass, the trace is not less than the largest eigenvalue.
double Passivity::lightestMass(const Measured& measured) const noexcept {
  double mobility = 0;
  for (int i = 0; i < kJointCount; ++i)
    mobility += measured.arm.J_BT.col(i).head<3>().squaredNorm() / std::max(inertia_[i], 1e-6);
  return 1 / std::max(mobility, 1e-6);
}

AddedDamping Passivity::operator()(const ControlChoice& choice, const HapticScene& scene, const Measured& measured,
                                   const AdmittanceState& ball, const FeltScene& felt,
                                   PassivityState& state) const noexcept {
  PassivityObserver& observer = state.observer;
  const HandMeetsTool now{measured.handForce, measured.p_WT, ball.position, ball.velocity};
  const bool isImpedance = choice.display == DisplayMode::impedance;
  if (isImpedance) {
    observer.seeTool(now);
  } else {
    observer.seeMass(now, scene.tool.mass, period_);
  }
  const double speed = isImpedance ? measured.v_WT.norm() : ball.velocity.norm();
  if (felt.zones == 0) observer.forgetSurplus(storedInWalls(scene, felt.contacts, period_ * speed));
  // What was given before it was switched on is not asked back.
  if (choice.passivity && !state.controlled) observer.energy = std::max(observer.energy, 0.0);
  state.controlled = choice.passivity;

  if (!choice.passivity) return {};
  if (isImpedance) return dampTool(-observer.energy, measured.v_WT, lightestMass(measured), period_, largestForce_);
  const Vector3 velocity = nextVelocity(ball, measured.handForce + felt.force, scene.tool.mass, period_);
  return dampMass(-observer.energy, velocity, scene.tool.mass, period_, largestForce_);
}

}  // namespace haptiv
