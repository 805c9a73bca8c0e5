#pragma once

#include <span>

#include "device/usb/peripheral/BoardPort.h"
#include "device/usb/peripheral/StandardRequests.h"

namespace haptiv::usb {

/// Endpoint 0 of the board: the standard requests, and the vendor requests of docs/usb-protocol.md. Whatever else is
/// asked for stalls.
class ControlPipe {
 public:
  ControlPipe(BoardPort& port, Descriptors descriptors) : port_(port), standard_(std::move(descriptors)) {}

  /// @param data  what an OUT request brings
  ControlAnswer answer(const SetupPacket& setup, std::span<const std::uint8_t> data);

  bool isOpen(std::uint8_t endpoint) const noexcept { return standard_.isOpen(endpoint); }
  const Descriptors& descriptors() const noexcept { return standard_.descriptors(); }
  /// As after a reset of the bus.
  void reset() noexcept { standard_.reset(); }

 private:
  ControlAnswer vendor(const SetupPacket& setup, std::span<const std::uint8_t> data);

  BoardPort& port_;
  StandardRequests standard_;
};

}  // namespace haptiv::usb
