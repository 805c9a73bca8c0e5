#include "device/simulated/HumanHand.h"

#include <Eigen/Geometry>
#include <cmath>

namespace haptiv {
namespace {

Vector3 noLongerThan(double limit, const Vector3& vector) noexcept {
  const double length = vector.norm();
  return length > limit ? Vector3(vector * (limit / length)) : vector;
}

/// The turn as its axis times its angle [rad].
Vector3 rotationVector(const Matrix3& R) noexcept {
  const Eigen::AngleAxisd turn(R);
  return turn.angle() * turn.axis();
}

}  // namespace

HumanHand::HumanHand(const HandModel& model)
    : model_(model), armStiffness_(1 / (1 / model.stiffness - 1 / model.gripStiffness)) {}

Wrench HumanHand::pull(const HandTarget& target, const Pose& handle, const Twist& motion, double dt) noexcept {
  const bool wants = target.holding && target.position.allFinite();
  if (!wants) lost_ = false;
  if (!wants || lost_) {
    holding_ = false;
    return {};
  }
  if (!holding_) takeHold(handle, motion);
  follow(target.position, dt);
  const Vector3 force = grip(handle.position, motion.linear);
  const Vector3 arm = noLongerThan(
      model_.peakForce, armStiffness_ * (wanted_ - hand_) + model_.damping * (wantedVelocity_ - handVelocity_));
  handVelocity_ += dt / model_.mass * (arm - force);
  hand_ += dt * handVelocity_;
  return {force, turn(target, handle, motion.angular, dt)};
}

void HumanHand::takeHold(const Pose& handle, const Twist& motion) noexcept {
  holding_ = true;
  wanted_ = hand_ = handle.position;
  wantedVelocity_ = handVelocity_ = motion.linear;
  slip_.setZero();
  held_ = wantedRotation_ = handle.rotation;
}

/// The exact answer of x'' = w^2 (target - x) - 2 w x' to a target at rest: stable for every dt.
void HumanHand::follow(const Vector3& target, double dt) noexcept {
  const double w = model_.bandwidth;
  const double decay = std::exp(-w * dt);
  const Vector3 offset = wanted_ - target;
  const Vector3 slope = wantedVelocity_ + w * offset;
  wanted_ = target + decay * (offset + dt * slope);
  wantedVelocity_ = decay * (wantedVelocity_ - w * dt * slope);
}

/// The spring stretches as far as the strength goes; what is beyond, the hand slips.
Vector3 HumanHand::grip(const Vector3& handle, const Vector3& velocity) noexcept {
  const Vector3 stretch = hand_ - handle - slip_;
  const Vector3 held = noLongerThan(model_.gripStrength / model_.gripStiffness, stretch);
  slip_ += stretch - held;
  lost_ = slip_.norm() > kLongestSlip;
  return noLongerThan(model_.gripStrength,
                      model_.gripStiffness * held + model_.gripDamping * (handVelocity_ - velocity));
}

Vector3 HumanHand::turn(const HandTarget& target, const Pose& handle, const Vector3& spin, double dt) noexcept {
  const Matrix3& wanted = target.orientation ? *target.orientation : held_;
  if (wanted.allFinite()) {
    const Vector3 left = -std::expm1(-model_.bandwidth * dt) * rotationVector(wanted * wantedRotation_.transpose());
    wantedRotation_ = Eigen::AngleAxisd(left.norm(), left.stableNormalized()) * wantedRotation_;
  }
  const Vector3 away = rotationVector(wantedRotation_ * handle.rotation.transpose());
  return noLongerThan(model_.peakTorque, model_.turnStiffness * away - model_.turnDamping * spin);
}

}  // namespace haptiv
