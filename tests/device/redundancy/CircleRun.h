#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "device/kinematics/ArmKinematics.h"
#include "device/redundancy/DriftCorrection.h"
#include "device/redundancy/RedundancyResolution.h"

namespace haptiv::test {

inline constexpr double kRadii[] = {0.05, 0.2, 0.4, 0.6, 0.8};

/// Where the paper's experiment 1 starts at radius r [m]: the SCARA links in two equal pairs, joint 3 on the positive
/// y side.
inline JointVector circleStart(const LinkLengths& links, double r) {
  constexpr double kPi = std::numbers::pi;
  const double bend = -kPi / 4;
  const double chord = 2 * links.scara * std::cos(bend / 2);  // of a pair, bend/2 off its first link
  const double elbow = std::acos(r / (2 * chord));
  JointVector q;
  q << elbow - bend / 2, bend, -2 * elbow - bend, bend, 0, 5 * kPi / 6, kPi / 3, 5 * kPi / 6, -3 * kPi / 4, 0;
  q[4] = kPi / 2 - q.head<4>().sum();
  return q;
}

/// VISHARD10 with its steps and weights, its criteria normalised at the starts of experiment 1.
inline DeviceDescription circleDevice() {
  return loadDeviceDescription("vishard10");
}

/// A moment of a run: what the arm is at, and the rates it gets.
struct CircleTick {
  JointVector q;
  ArmPose pose;
  JointVector rates;
  double positionError;  ///< [m]
};

/// One turn about joint axis 1 at 1 m/s, clockwise seen from +z, at 1 kHz, closed loop; orientation and height held.
inline void runCircle(const DeviceDescription& description, const RedundancyResolution& resolution,
                      const ResolutionChoice& choice, double r, const std::function<void(const CircleTick&)>& see) {
  constexpr double kPeriod = 1e-3, kSpeed = 1;
  const ArmKinematics arm(description);
  JointVector q = circleStart(description.links, r);
  const Pose start = arm.forward(q);
  const auto at = [&](double t) {
    Pose wanted = start;
    wanted.position.head<2>() = r * Eigen::Vector2d(std::cos(t * kSpeed / r), -std::sin(t * kSpeed / r));
    return wanted;
  };
  const int ticks = static_cast<int>(2 * std::numbers::pi * r / kSpeed / kPeriod);
  for (int tick = 0; tick < ticks; ++tick) {
    const Pose wanted = at(tick * kPeriod);
    const ArmPose pose = arm.evaluate(q);
    Vector6 twist = driftCorrection(wanted, pose.X_BT, description.control.driftGain);
    twist.head<3>() += (at((tick + 1) * kPeriod).position - wanted.position) / kPeriod;
    const JointVector rates = resolution.rates(choice, q, pose.J_BT, twist, kPeriod);
    see({q, pose, rates, (pose.X_BT.position - wanted.position).norm()});
    q += kPeriod * rates;
  }
}

}  // namespace haptiv::test
