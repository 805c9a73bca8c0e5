#include "device/usb/protocol/SetupPacket.h"

#include "device/usb/protocol/WireBytes.h"

namespace haptiv::usb {

SetupPacket decodeSetup(std::span<const std::uint8_t, 8> bytes) noexcept {
  WireReader in(bytes);
  SetupPacket setup;
  setup.requestType = in.unsignedInteger<std::uint8_t>();
  setup.request = in.unsignedInteger<std::uint8_t>();
  setup.value = in.unsignedInteger<std::uint16_t>();
  setup.index = in.unsignedInteger<std::uint16_t>();
  setup.length = in.unsignedInteger<std::uint16_t>();
  return setup;
}

ControlAnswer cutTo(std::uint16_t length, ControlAnswer answer) {
  if (answer && answer->size() > length) answer->resize(length);
  return answer;
}

}  // namespace haptiv::usb
