#pragma once

#include <string>

#include "device/board/BoardSettings.h"
#include "device/usb/protocol/FrameHead.h"

namespace haptiv::usb {

/// Vendor requests to the interface; the board answers a refused one with a stall.
enum class ControlRequest : std::uint8_t {
  identity = 0x01,       ///< in
  capabilities = 0x02,   ///< in
  getThresholds = 0x03,  ///< in
  setThresholds = 0x04,  ///< out
  home = 0x05,           ///< out
};

inline constexpr std::size_t kNameSize = 24;
inline constexpr std::size_t kIdentitySize = kHeadSize + 4 + kNameSize + kCrcSize;
inline constexpr std::size_t kCapabilitiesSize = kHeadSize + 2 * 4 * kJointCount + kCrcSize;
inline constexpr std::size_t kThresholdsSize = kHeadSize + 8 + 4 * kJointCount + kCrcSize;
inline constexpr std::size_t kHomeSize = kHeadSize + 4 * kJointCount + kCrcSize;
inline constexpr std::size_t kLargestControlFrame = kCapabilitiesSize;

/// Which board it is.
struct Identity {
  std::uint16_t firmware = 0;  ///< major in the upper byte, minor in the lower
  std::uint8_t joints = 0;     ///< 1 to 10
  std::string name;            ///< of the device description, at most 24 printable ASCII characters
  bool homed = false;          ///< the encoders have been given a zero since the board was switched on
  bool operator==(const Identity&) const = default;
};

/// What its drives can do; rounded to 1e-6.
struct Capabilities {
  JointVector rateLimit = JointVector::Zero();    ///< [rad/s]
  JointVector torqueLimit = JointVector::Zero();  ///< [N m]
};

using HomeCounts = std::array<std::int32_t, kJointCount>;
using ControlBytes = std::array<std::uint8_t, kLargestControlFrame>;

/// Each writes its frame to the first bytes of `out` and returns them. Thread: any; not for the servo.
std::span<const std::uint8_t> encode(const Identity& identity, ControlBytes& out);
std::span<const std::uint8_t> encode(const Capabilities& capabilities, ControlBytes& out);
std::span<const std::uint8_t> encode(const CircuitThresholds& thresholds, ControlBytes& out);
std::span<const std::uint8_t> encode(const HomeCounts& counts, ControlBytes& out);

/// Each changes its second argument only where the frame is whole.
FrameFault decode(std::span<const std::uint8_t> bytes, Identity& identity);
FrameFault decode(std::span<const std::uint8_t> bytes, Capabilities& capabilities);
FrameFault decode(std::span<const std::uint8_t> bytes, CircuitThresholds& thresholds);
FrameFault decode(std::span<const std::uint8_t> bytes, HomeCounts& counts);

}  // namespace haptiv::usb
