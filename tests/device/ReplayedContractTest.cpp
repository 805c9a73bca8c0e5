#include "device/replayed/ReplayedDevice.h"
#include "device/simulated/SimulatedDevice.h"
#include "tests/device/DeviceContract.h"

namespace haptiv::test {
namespace {

/// Half a second of the simulated arm, its second joint turning.
std::vector<DeviceReading> recording(const DeviceDescription& description) {
  SimulatedDevice device(description, description.homeAngles, nullptr, 1);
  device.start(1e-3);
  DeviceCommand command;
  command.enabled = true;
  command.jointRates[1] = 0.5;
  std::vector<DeviceReading> readings{device.read()};
  for (int i = 0; i < 500; ++i) {
    device.write(command);
    readings.push_back(device.read());
  }
  return readings;
}

const Candidate kReplayed{
    "Replayed",
    [](const DeviceDescription& description) { return std::make_unique<ReplayedDevice>(recording(description)); },
    "vishard10", false};

INSTANTIATE_TEST_SUITE_P(Recording, DeviceContract, testing::Values(kReplayed), nameOf);

}  // namespace
}  // namespace haptiv::test
