#pragma once

#include "device/board/Board.h"
#include "device/usb/protocol/ControlFrames.h"
#include "device/usb/protocol/StreamFrames.h"

namespace haptiv::usb {

/// The firmware's side of the wire: bytes to and from a Board. What a bus carries it is told, and asked for, here.
/// Realtime-safe: yes, but for control requests.
class BoardPort {
 public:
  BoardPort(Board& board, FrameForm form, Identity identity) noexcept
      : board_(board), form_(form), identity_(std::move(identity)) {}

  /// The next packet of the IN endpoint: the board's state now.
  std::span<const std::uint8_t> packetIn(std::span<std::uint8_t, kLargestFrame> out) noexcept;
  /// A packet that came to the OUT endpoint, whatever it is.
  void packetOut(std::span<const std::uint8_t> bytes) noexcept;

  /// A request that asks for data: the bytes to answer with, none for a stall.
  std::span<const std::uint8_t> controlIn(std::uint8_t request, ControlBytes& out) const;
  /// A request that brings data. False: stall.
  bool controlOut(std::uint8_t request, std::span<const std::uint8_t> bytes);

 private:
  Board& board_;
  FrameForm form_;
  Identity identity_;
  std::uint32_t sequence_ = 0;
  BoardCommand last_;  // to which the packed form's lower bits are completed
};

}  // namespace haptiv::usb
