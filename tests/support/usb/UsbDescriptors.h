#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace haptiv::test {

using Bytes = std::vector<std::uint8_t>;

enum class UsbSpeed { full, high };

struct UsbEndpoint {
  std::uint8_t address = 0;     ///< with the direction in bit 7
  std::uint8_t attributes = 3;  ///< 2 bulk, 3 interrupt
  std::uint16_t maxPacket = 64;
  std::uint8_t interval = 1;
};

/// What a virtual device says it is; one configuration with one interface.
struct UsbDescriptors {
  std::uint16_t vendor = 0, product = 0;
  std::string manufacturer, productName, serial;  ///< empty: has none
  UsbSpeed speed = UsbSpeed::high;
  std::uint8_t interfaceClass = 0xff, subclass = 0, protocol = 0;
  std::vector<UsbEndpoint> endpoints;
};

/// As they are on the wire.
Bytes deviceDescriptor(const UsbDescriptors& device);
Bytes configurationDescriptor(const UsbDescriptors& device);
/// String `index`: 0 the languages, 1 manufacturer, 2 product, 3 serial number; empty where there is none.
Bytes stringDescriptor(const UsbDescriptors& device, int index);

}  // namespace haptiv::test
