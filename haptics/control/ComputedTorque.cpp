#include "haptics/control/ComputedTorque.h"

#include <cmath>

namespace haptiv {

ComputedTorque::ComputedTorque(const DeviceDescription& description)
    : dynamics_(description),
      viscous_(description.drives.viscousFriction),
      coulomb_(description.drives.coulombFriction) {
  const double frequency = description.control.trackingFrequency;
  stiffness_ = frequency * frequency;
  damping_ = 2 * description.control.trackingDampingRatio * frequency;
}

JointVector ComputedTorque::operator()(const JointMotion& desired, const Measured& measured,
                                       const Wrench& hand_B) const noexcept {
  const JointVector accelerations = desired.accelerations + damping_ * (desired.rates - measured.rates) +
                                    stiffness_ * (desired.angles - measured.angles);
  Vector6 hand;
  hand << hand_B.force, hand_B.torque;
  JointVector torques = dynamics_.inverse(measured.angles, measured.rates, accelerations);
  for (int i = 0; i < kJointCount; ++i)
    torques[i] += viscous_[i] * desired.rates[i] + coulomb_[i] * std::tanh(desired.rates[i] / kSliding);
  return torques - measured.arm.J_BT.transpose() * hand;
}

}  // namespace haptiv
