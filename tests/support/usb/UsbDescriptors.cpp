#include "tests/support/usb/UsbDescriptors.h"

#include <initializer_list>

namespace haptiv::test {

namespace {

constexpr std::uint8_t kDevice = 1, kConfiguration = 2, kString = 3, kInterface = 4, kEndpoint = 5;

std::uint8_t low(std::size_t word) {
  return static_cast<std::uint8_t>(word);
}
std::uint8_t high(std::size_t word) {
  return static_cast<std::uint8_t>(word >> 8);
}
std::uint8_t indexOf(const std::string& text, std::uint8_t index) {
  return text.empty() ? 0 : index;
}

void append(Bytes& bytes, std::initializer_list<std::uint8_t> more) {
  for (const std::uint8_t byte : more) bytes.push_back(byte);
}

}  // namespace

Bytes deviceDescriptor(const UsbDescriptors& d) {
  return {18,
          kDevice,
          0x00,
          0x02,
          0,
          0,
          0,
          64,
          low(d.vendor),
          high(d.vendor),
          low(d.product),
          high(d.product),
          0x00,
          0x01,
          indexOf(d.manufacturer, 1),
          indexOf(d.productName, 2),
          indexOf(d.serial, 3),
          1};
}

Bytes configurationDescriptor(const UsbDescriptors& d) {
  const std::size_t total = 9 + 9 + 7 * d.endpoints.size();
  Bytes bytes{9, kConfiguration, low(total), high(total), 1, 1, 0, 0x80, 50};
  bytes.insert(bytes.end(),
               {9, kInterface, 0, 0, low(d.endpoints.size()), d.interfaceClass, d.subclass, d.protocol, 0});
  for (const UsbEndpoint& e : d.endpoints)
    append(bytes, {7, kEndpoint, e.address, e.attributes, low(e.maxPacket), high(e.maxPacket), e.interval});
  return bytes;
}

Bytes stringDescriptor(const UsbDescriptors& d, int index) {
  if (index == 0) return {4, kString, 0x09, 0x04};
  if (index < 1 || index > 3) return {};
  const std::string& text = index == 1 ? d.manufacturer : index == 2 ? d.productName : d.serial;
  if (text.empty()) return {};
  Bytes bytes{low(2 + 2 * text.size()), kString};
  for (const char c : text) append(bytes, {static_cast<std::uint8_t>(c), 0});
  return bytes;
}

}  // namespace haptiv::test
