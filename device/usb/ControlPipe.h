#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "device/usb/BoardPort.h"
#include "device/usb/protocol/Descriptors.h"

namespace haptiv::usb {

/// The eight bytes with which every control request begins.
struct SetupPacket {
  std::uint8_t requestType = 0;  ///< bmRequestType
  std::uint8_t request = 0;      ///< bRequest
  std::uint16_t value = 0, index = 0, length = 0;

  bool isIn() const noexcept { return (requestType & 0x80) != 0; }
};
SetupPacket decodeSetup(std::span<const std::uint8_t, 8> bytes) noexcept;

/// Endpoint 0 of the board: the standard requests of USB 2.0, chapter 9, as far as a device of one configuration has
/// them, and the vendor requests of docs/usb-protocol.md. Whatever else is asked for stalls.
class ControlPipe {
 public:
  ControlPipe(BoardPort& port, Descriptors descriptors) : port_(port), descriptors_(std::move(descriptors)) {}

  /// @param data  what an OUT request brings
  /// @return      what an IN request is answered with, no longer than asked for, or no bytes; nothing: a stall
  std::optional<std::vector<std::uint8_t>> answer(const SetupPacket& setup, std::span<const std::uint8_t> data);

  /// Whether an endpoint's packets go through: the host has chosen the configuration, and the endpoint is not halted.
  bool isOpen(std::uint8_t endpoint) const noexcept;
  const Descriptors& descriptors() const noexcept { return descriptors_; }
  /// As after a reset of the bus.
  void reset() noexcept;

 private:
  using Answer = std::optional<std::vector<std::uint8_t>>;
  Answer standardIn(const SetupPacket& setup) const;
  Answer standardOut(const SetupPacket& setup);
  Answer vendor(const SetupPacket& setup, std::span<const std::uint8_t> data);
  bool* haltOf(std::uint16_t endpoint) noexcept;

  BoardPort& port_;
  Descriptors descriptors_;
  std::uint8_t configuration_ = 0;
  bool stateHalted_ = false, commandHalted_ = false;
};

}  // namespace haptiv::usb
