#pragma once

#include "device/usb/protocol/Descriptors.h"
#include "device/usb/protocol/StreamFrames.h"

namespace haptiv::usb {

inline constexpr std::uint16_t kVendorId = 0x1209;  ///< with kProductId pid.codes' number for tests
inline constexpr std::uint16_t kProductId = 0x0001;
inline constexpr std::uint8_t kBoardInterface = 0;
inline constexpr std::uint8_t kBoardClass = 0xff, kBoardSubclass = 0x48, kBoardProtocol = 0x01;
inline constexpr std::uint8_t kStateEndpoint = 0x81;    ///< interrupt IN
inline constexpr std::uint8_t kCommandEndpoint = 0x01;  ///< interrupt OUT
inline constexpr std::uint16_t kCommandPacket = 64;     ///< its wMaxPacketSize

/// wMaxPacketSize of the IN endpoint, by which the host tells high speed (full frames) from full speed (packed ones).
constexpr std::uint16_t statePacket(FrameForm form) {
  return form == FrameForm::full ? 128 : 64;
}

/// What the board says of itself on the bus: the tables of docs/usb-protocol.md. Thread: any.
///
/// @param form      full: the board is in high speed; packed: it knows full speed only
/// @param firmware  major in the upper byte, minor in the lower; becomes bcdDevice
/// @param serial    1 to kLongestString printable ASCII characters
/// Throws std::runtime_error where the serial is none.
UsbProfile boardProfile(FrameForm form, std::uint16_t firmware, const std::string& serial);

}  // namespace haptiv::usb
