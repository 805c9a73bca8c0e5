#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>

#include "device/DeviceDescription.h"
#include "device/HapticDevice.h"

namespace haptiv::test {

/// A device with nobody at its handle, standing at its home.
struct Candidate {
  std::string name;
  std::function<std::unique_ptr<HapticDevice>(const DeviceDescription&)> make;
};

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

  DeviceDescription description_ = loadDeviceDescription("vishard10");
  std::unique_ptr<HapticDevice> device_ = GetParam().make(description_);
};

}  // namespace haptiv::test
