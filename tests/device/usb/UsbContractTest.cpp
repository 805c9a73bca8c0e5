/// The device contract for the USB device: real libusb over a virtual bus, the board's own firmware behind it.
#include "tests/device/DeviceContract.h"
#include "tests/device/usb/bench/BenchedUsbDevice.h"

namespace haptiv::test {
namespace {

Candidate over(const char* name, UsbSpeed speed) {
  return {name, [speed](const DeviceDescription& description) {
            return std::make_unique<BenchedUsbDevice>(description, speed);
          }};
}

INSTANTIATE_TEST_SUITE_P(Usb, DeviceContract,
                         testing::Values(over("HighSpeed", UsbSpeed::high), over("FullSpeed", UsbSpeed::full)), nameOf);

}  // namespace
}  // namespace haptiv::test
