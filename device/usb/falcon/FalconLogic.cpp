#include "device/usb/falcon/FalconLogic.h"

#include <algorithm>
#include <cmath>

namespace haptiv::falcon {
namespace {

constexpr int kLegs = DeltaGeometry::kLegs;
constexpr double kMostCounts = 32767;  // of 16 bits

std::uint8_t ledsOf(Homing homing, bool isDriven) noexcept {
  if (homing != Homing::homed) return kRed;
  return isDriven ? kGreen : kBlue;
}

}  // namespace

Homing next(Homing homing, std::uint8_t homedLegs) noexcept {
  const bool all = homedLegs == kAllHomed;
  if (homing == Homing::searching) return all ? Homing::homed : Homing::searching;
  return all ? homing : Homing::lost;
}

Logic::Logic(const DeviceDescription& description) noexcept
    : torqueCounts_(description.falcon.torqueCounts),
      mostCounts_(std::min(description.falcon.mostTorqueCounts, kMostCounts)) {
  const JointVector countsPerRadian = description.drives.countsPerRadian();
  for (int i = 0; i < kLegs; ++i) {
    zeroCounts_[i] = static_cast<std::int32_t>(
        std::clamp(std::round(description.falcon.homedAngle * countsPerRadian[i]), -1e9, 1e9));
    torqueLimit_[i] = description.drives.torqueLimit[i];
  }
}

DeviceReading Logic::reading(const State& state, Homing homing) const noexcept {
  DeviceReading reading;
  reading.connected = homing == Homing::homed;
  reading.inputs = 0;
  for (std::size_t i = 0; i < kLegs; ++i) reading.encoderCounts[i] = zeroCounts_[i] + state.counts[i];
  if (!reading.connected) return reading;
  if ((state.buttons & kDeadManButton) != 0) reading.inputs |= kInputDeadMan;
  if ((state.buttons & kResetButton) != 0) reading.inputs |= kInputReset;
  return reading;
}

Order Logic::order(const DeviceCommand& command, const State& state, Homing homing) const noexcept {
  Order order;
  const bool isDriven = homing == Homing::homed && command.enabled && command.mode == DriveMode::torque &&
                        (state.buttons & kDeadManButton) != 0 && command.jointTorques.allFinite();
  order.leds = ledsOf(homing, isDriven);
  if (!isDriven) return order;
  for (int i = 0; i < kLegs; ++i) {
    const double torque = std::clamp(command.jointTorques[i], -torqueLimit_[i], torqueLimit_[i]);
    const double value = std::clamp(std::round(torqueCounts_ * torque), -mostCounts_, mostCounts_);
    order.motors[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(value);
  }
  return order;
}

}  // namespace haptiv::falcon
