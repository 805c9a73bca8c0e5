#pragma once

#include <deque>

#include "tests/support/usb/VirtualUsbDevice.h"

namespace haptiv::test {

/// A SpaceMouse that says what the test has it say, a report an interval. As most have, it has no serial number.
class VirtualSpaceMouse : public VirtualUsbDevice {
 public:
  explicit VirtualSpaceMouse(std::uint16_t vendor = 0x046d, std::uint16_t product = 0xc626)
      : vendor_(vendor), product_(product) {}

  UsbDescriptors descriptors() const override {
    return {vendor_, product_, "3Dconnexion", "SpaceNavigator", "", UsbSpeed::full, 3, 0, 0, {{0x81, 3, 16, 8}}};
  }
  std::optional<Bytes> packetIn(std::uint8_t) override {
    if (reports.empty()) return std::nullopt;
    const Bytes report = reports.front();
    reports.pop_front();
    return report;
  }
  void packetOut(std::uint8_t, std::span<const std::uint8_t>) override {}
  void advance(std::int64_t) override {}

  std::deque<Bytes> reports;

 private:
  std::uint16_t vendor_, product_;
};

}  // namespace haptiv::test
