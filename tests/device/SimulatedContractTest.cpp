#include "device/simulated/SimulatedDevice.h"
#include "tests/device/DeviceContract.h"

namespace haptiv::test {
namespace {

const Candidate kSimulated{"Simulated", [](const DeviceDescription& description) {
                             return std::make_unique<SimulatedDevice>(description, description.homeAngles, nullptr, 1);
                           }};

INSTANTIATE_TEST_SUITE_P(SimulatedArm, DeviceContract, testing::Values(kSimulated), nameOf);

}  // namespace
}  // namespace haptiv::test
