#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace haptiv::usb {

/// The eight bytes with which every control request begins.
struct SetupPacket {
  std::uint8_t requestType = 0;  ///< bmRequestType
  std::uint8_t request = 0;      ///< bRequest
  std::uint16_t value = 0, index = 0, length = 0;

  bool isIn() const noexcept { return (requestType & 0x80) != 0; }
  bool isStandard() const noexcept { return (requestType & 0x60) == 0; }
};
SetupPacket decodeSetup(std::span<const std::uint8_t, 8> bytes) noexcept;

/// bmRequestType of the standard requests, without the direction.
inline constexpr std::uint8_t kToDevice = 0x00, kToInterface = 0x01, kToEndpoint = 0x02;

/// bRequest of the standard requests: USB 2.0, table 9-4.
enum class StandardRequest : std::uint8_t {
  getStatus = 0,
  clearFeature = 1,
  setFeature = 3,
  setAddress = 5,
  getDescriptor = 6,
  getConfiguration = 8,
  setConfiguration = 9,
  getInterface = 10,
  setInterface = 11,
};

inline constexpr std::uint16_t kEndpointHalt = 0;  ///< the feature of an endpoint, in wValue

/// What a device says to a control request: the bytes of an IN request, none for an OUT request; nothing: a stall.
using ControlAnswer = std::optional<std::vector<std::uint8_t>>;

/// The same, no longer than the host asked for.
ControlAnswer cutTo(std::uint16_t length, ControlAnswer answer);

}  // namespace haptiv::usb
