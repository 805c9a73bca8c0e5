#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <ostream>
#include <string>

#include "device/HapticDevice.h"
#include "device/described/DeviceDescription.h"

namespace haptiv::test {

/// A device with nobody at its handle, standing at its home.
struct Candidate {
  std::string name;
  std::function<std::unique_ptr<HapticDevice>(const DeviceDescription&)> make;
  std::string description = "vishard10";
  bool obeys = true;  ///< false: it moves as it did when it was recorded
};

inline void PrintTo(const Candidate& candidate, std::ostream* out) {
  *out << candidate.name;
}

inline std::string nameOf(const testing::TestParamInfo<Candidate>& instance) {
  return instance.param.name;
}

/// What every HapticDevice keeps to: the laws are in DeviceContractTest.cpp. Another kind of device joins by an
/// INSTANTIATE_TEST_SUITE_P of its own.
class DeviceContract : public testing::TestWithParam<Candidate> {
 protected:
  static constexpr double kTick = 1e-3;  // [s]

  DeviceReading run(const DeviceCommand& command, int ticks) {
    for (int i = 0; i < ticks; ++i) device_->write(command);
    return device_->read();
  }
  static DeviceCommand turning(int joint, double rate) {
    DeviceCommand command;
    command.enabled = true;
    command.jointRates[joint] = rate;
    return command;
  }

  bool obeys() const { return GetParam().obeys; }
  bool followsRates() const { return obeys() && description_.type == DeviceType::admittance; }
  /// Turns a joint forwards, in the way that the device can.
  DeviceCommand moving(int joint) const {
    if (description_.type == DeviceType::admittance) return turning(joint, 1);
    DeviceCommand command;
    command.enabled = true;
    command.mode = DriveMode::torque;
    command.jointTorques[joint] = 5 * description_.drives.coulombFriction[joint];
    return command;
  }

  DeviceDescription description_ = loadDeviceDescription(GetParam().description);
  std::unique_ptr<HapticDevice> device_ = GetParam().make(description_);
};

}  // namespace haptiv::test
