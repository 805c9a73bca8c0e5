#include "app/devicecheck/ArmMover.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "device/redundancy/DriftCorrection.h"
#include "device/redundancy/JointLimiter.h"

namespace haptiv {
namespace {

constexpr double kPeriod = 1e-3;                // [s]
constexpr double kSpeed = 1;                    // [m/s]
constexpr double kTurnRate = std::numbers::pi;  // [rad/s]
constexpr double kMostSlowed = 5;               // times as long as at full speed, and the motion is given up
constexpr double kNearest = 1e-9;               // [m]

Matrix3 turned(const Vector3& rates, double seconds) {
  const double rate = rates.norm();
  if (rate == 0) return Matrix3::Identity();
  return Eigen::AngleAxisd(rate * seconds, rates / rate).toRotationMatrix();
}

}  // namespace

ArmMover::ArmMover(const DeviceDescription& device, const ArmKinematics& arm, const RedundancyResolution& resolution,
                   const ResolutionChoice& choice)
    : device_(&device), arm_(&arm), resolution_(&resolution), choice_(choice) {
  goHome();
}

void ArmMover::goHome() {
  q_ = device_->homeAngles;
  actual_ = arm_->evaluate(q_);
  wanted_ = actual_.X_BT;
}

bool ArmMover::moveTo(const Vector3& p_BT, const Visit& visit) {
  const Vector3 way = p_BT - wanted_.position;
  const double length = way.norm();
  if (length < kNearest) return true;
  Vector6 twist = Vector6::Zero();
  twist.head<3>() = kSpeed / length * way;
  return move(twist, length / kSpeed, visit);
}

bool ArmMover::turnAbout(const Vector3& axis, const Visit& visit) {
  Vector6 twist = Vector6::Zero();
  twist.tail<3>() = kTurnRate * axis;
  return move(twist, 2 * std::numbers::pi / kTurnRate, visit);
}

bool ArmMover::move(const Vector6& twist, double seconds, const Visit& visit) {
  const Pose start = wanted_;
  const auto most = static_cast<long>(std::ceil(kMostSlowed * seconds / kPeriod));
  double done = 0;  // of the way [s]
  for (long tick = 0; done < seconds && tick < most; ++tick) {
    const double part = std::min(1., (seconds - done) / kPeriod);  // of the last tick
    const Vector6 asked = part * twist + driftCorrection(wanted_, actual_.X_BT, device_->control.driftGain);
    const JointVector rates = resolution_->rates(choice_, q_, actual_.J_BT, asked, kPeriod);
    const double slowed = slowDownFactor(rates, device_->drives.rateLimit);
    q_ += slowed * kPeriod * rates;
    done += part * slowed * kPeriod;
    wanted_ = {start.position + done * twist.head<3>(), turned(twist.tail<3>(), done) * start.rotation};
    actual_ = arm_->evaluate(q_);
    visit(q_, actual_, wanted_);
  }
  return done >= seconds - kNearest;
}

}  // namespace haptiv
