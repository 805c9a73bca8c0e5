#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "device/usb/protocol/StreamFrames.h"

namespace haptiv::usb {

inline constexpr std::uint16_t kVendorId = 0x1209;  ///< with kProductId pid.codes' number for tests
inline constexpr std::uint16_t kProductId = 0x0001;
inline constexpr std::uint8_t kBoardInterface = 0;
inline constexpr std::uint8_t kBoardClass = 0xff, kBoardSubclass = 0x48, kBoardProtocol = 0x01;
inline constexpr std::uint8_t kStateEndpoint = 0x81;    ///< interrupt IN
inline constexpr std::uint8_t kCommandEndpoint = 0x01;  ///< interrupt OUT
inline constexpr std::uint16_t kCommandPacket = 64;     ///< its wMaxPacketSize
inline constexpr std::size_t kLongestSerial = 126;      ///< characters of a string descriptor

/// wMaxPacketSize of the IN endpoint, by which the host tells high speed (full frames) from full speed (packed ones).
constexpr std::uint16_t statePacket(FrameForm form) {
  return form == FrameForm::full ? 128 : 64;
}

enum class DescriptorType : std::uint8_t {
  device = 1,
  configuration = 2,
  string = 3,
  interface = 4,
  endpoint = 5,
  deviceQualifier = 6,
  otherSpeedConfiguration = 7,
};

/// What the board says of itself on the bus: the tables of docs/usb-protocol.md as bytes. Thread: any.
class Descriptors {
 public:
  /// @param form      full: the board is in high speed; packed: it knows full speed only
  /// @param firmware  major in the upper byte, minor in the lower; becomes bcdDevice
  /// @param serial    1 to kLongestSerial printable ASCII characters
  /// Throws std::runtime_error where the serial is none.
  Descriptors(FrameForm form, std::uint16_t firmware, const std::string& serial);

  /// The answer to GET_DESCRIPTOR: the type stands in the upper byte of wValue, the index in the lower. None: stall.
  std::span<const std::uint8_t> find(std::uint16_t wValue) const;
  /// Device and configuration one after the other, as sysfs has them in `descriptors`.
  std::vector<std::uint8_t> deviceAndConfiguration() const;

 private:
  std::vector<std::uint8_t> device_, configuration_, qualifier_, otherSpeed_;
  std::vector<std::vector<std::uint8_t>> strings_;
};

}  // namespace haptiv::usb
