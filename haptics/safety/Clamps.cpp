#include "haptics/safety/Clamps.h"

#include <array>
#include <bit>

namespace haptiv {
namespace {

/// v, no longer than `most`.
Vector3 shortened(const Vector3& v, double most, Clamp clamp, std::uint32_t& clamps) noexcept {
  const double length = v.norm();
  if (!(length > most)) return v;
  clamps |= clamp;
  return v * (most / length);
}

void limit(JointVector& values, const JointVector& limits, Clamp clamp, std::uint32_t& clamps) noexcept {
  const JointVector wanted = values;
  if (!wanted.allFinite()) return;
  values = wanted.cwiseMin(limits).cwiseMax(-limits);
  if (values != wanted) clamps |= clamp;
}

}  // namespace

std::vector<std::string> clampNames(std::uint32_t clamps) {
  constexpr std::array<const char*, kClampCount> kNames = {"force",      "torque",       "speed",     "acceleration",
                                                           "joint rate", "joint torque", "correction"};
  std::vector<std::string> names;
  for (; clamps != 0; clamps &= clamps - 1) {
    const auto first = static_cast<std::size_t>(std::countr_zero(clamps));
    names.emplace_back(first < kNames.size() ? kNames[first] : "unknown clamp");
  }
  return names;
}

Clamps::Clamps(const DeviceDescription& description, double period)
    : safety_(description.safety),
      sentSpeed_(kSentShare * description.safety.speedClamp),
      rateLimit_(description.drives.rateLimit),
      torqueLimit_(description.drives.torqueLimit),
      period_(period) {}

Vector3 Clamps::force(const Vector3& force, std::uint32_t& clamps) const noexcept {
  return shortened(force, safety_.forceClamp, kClampForce, clamps);
}

Vector3 Clamps::torque(const Vector3& torque, std::uint32_t& clamps) const noexcept {
  return shortened(torque, safety_.torqueClamp, kClampTorque, clamps);
}

Vector3 Clamps::velocity(const Vector3& before, const Vector3& wanted, double scale,
                         std::uint32_t& clamps) const noexcept {
  const double fastest = before.norm() + scale * safety_.accelerationClamp * period_;
  const Vector3 gained = shortened(wanted, fastest, kClampAcceleration, clamps);
  return shortened(gained, scale * sentSpeed_, kClampSpeed, clamps);
}

void Clamps::command(DeviceCommand& command, const Jacobian& J_BT, std::uint32_t& clamps) const noexcept {
  const double speed = (J_BT.topRows<3>() * command.jointRates).norm();
  if (speed > sentSpeed_) {
    command.jointRates *= sentSpeed_ / speed;
    clamps |= kClampCorrection;
  }
  limit(command.jointRates, rateLimit_, kClampJointRate, clamps);
  limit(command.jointTorques, torqueLimit_, kClampJointTorque, clamps);
}

}  // namespace haptiv
