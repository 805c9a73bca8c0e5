#include "haptics/control/ComputedTorque.h"

namespace haptiv {

ComputedTorque::ComputedTorque(const DeviceDescription& description) : dynamics_(description) {
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
  return dynamics_.inverse(measured.angles, measured.rates, accelerations) - measured.arm.J_BT.transpose() * hand;
}

}  // namespace haptiv
