/// The device contract for the Falcon's driver: real libusb over a virtual bus, a virtual Falcon behind it.
#include "tests/device/DeviceContract.h"
#include "tests/device/usb/falcon/BenchedFalcon.h"

namespace haptiv::test {
namespace {

const Candidate kFalcon{
    "Falcon",
    [](const DeviceDescription& description) { return std::make_unique<falcon::test::BenchedFalcon>(description); },
    "falcon"};

INSTANTIATE_TEST_SUITE_P(Falcon, DeviceContract, testing::Values(kFalcon), nameOf);

}  // namespace
}  // namespace haptiv::test
