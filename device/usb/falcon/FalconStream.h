#pragma once

#include "device/usb/falcon/FalconPackets.h"

namespace haptiv::falcon {

/// The bytes of the device's IN endpoint as they come, in any pieces, and the states found in them.
///
/// Each packet of USB, 64 bytes at most, begins with two bytes of the serial chip's own (modem and line status), also
/// where it has nothing else to tell. What is left is a stream: a packet of the Falcon's may lie across two of USB's.
/// What is no packet is skipped up to the next '<' and counted.
class Stream {
 public:
  static constexpr std::size_t kUsbPacket = 64;
  static constexpr std::size_t kStatus = 2;

  /// Takes one transfer. Returns the newest state in it, if there is one.
  /// Realtime-safe: yes.
  std::optional<State> take(std::span<const std::uint8_t> transfer) noexcept;

  /// A new stream begins: what was held of a packet is not its beginning. Realtime-safe: yes.
  void restart() noexcept { count_ = 0; }

  std::uint32_t states() const noexcept { return states_; }    ///< found so far
  std::uint32_t damaged() const noexcept { return damaged_; }  ///< beginnings of a packet that became none

 private:
  void take(std::uint8_t byte, std::optional<State>& newest) noexcept;
  /// Drops the first byte, and all up to the next '<' that is held.
  void resynchronise() noexcept;

  Packet held_{};
  std::size_t count_ = 0;
  std::uint32_t states_ = 0;
  std::uint32_t damaged_ = 0;
};

}  // namespace haptiv::falcon
