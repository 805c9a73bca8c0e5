#pragma once

#include <deque>

#include "device/usb/peripheral/StandardRequests.h"
#include "tests/support/usb/VirtualUsbDevice.h"

namespace haptiv::test {

/// A SpaceMouse that says what the test has it say, a report an interval. As most have, it has no serial number.
class VirtualSpaceMouse : public VirtualUsbDevice {
 public:
  explicit VirtualSpaceMouse(std::uint16_t vendor = 0x046d, std::uint16_t product = 0xc626)
      : standard_(usb::Descriptors(profile(vendor, product))) {}

  const usb::Descriptors& descriptors() const override { return standard_.descriptors(); }
  usb::ControlAnswer answer(const usb::SetupPacket& setup, std::span<const std::uint8_t>) override {
    return standard_.answer(setup);
  }
  bool isOpen(std::uint8_t endpoint) const override { return standard_.isOpen(endpoint); }
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
  static usb::UsbProfile profile(std::uint16_t vendor, std::uint16_t product) {
    usb::UsbProfile profile;
    profile.vendor = vendor;
    profile.product = product;
    profile.manufacturer = "3Dconnexion";
    profile.productName = "SpaceNavigator";
    profile.speed = UsbSpeed::full;
    profile.interfaceClass = 3;
    profile.endpoints = {{0x81, usb::TransferType::interrupt, 16, 8}};
    return profile;
  }

  usb::StandardRequests standard_;
};

}  // namespace haptiv::test
