#include "device/simulated/plant/JointDrive.h"

#include <cmath>

namespace haptiv {
namespace {

constexpr double kObserver = 2;  // times as quick as the velocity loop

}  // namespace

TorqueLaw JointDrive::rate(double setPoint, double weight) noexcept {
  if (!holdsRate_) load_ = weight;
  holdsRate_ = true;
  const double gain = settings_.inertia * settings_.bandwidth;
  return {gain * std::clamp(setPoint, -settings_.rate, settings_.rate) + load_, gain, settings_.torque};
}

TorqueLaw JointDrive::torque(double setPoint) noexcept {
  holdsRate_ = false;
  return {setPoint, 0, settings_.torque};
}

TorqueLaw JointDrive::brake() noexcept {
  holdsRate_ = false;
  return {0, settings_.brakeDamping, settings_.torque};
}

void JointDrive::moved(double torque, double acceleration, double dt) noexcept {
  if (!holdsRate_) return;
  const double part = -std::expm1(-kObserver * settings_.bandwidth * dt);
  load_ += part * (torque - settings_.inertia * acceleration - load_);
}

}  // namespace haptiv
