#pragma once

#include "device/usb/protocol/Descriptors.h"
#include "device/usb/protocol/SetupPacket.h"

namespace haptiv::usb {

/// The standard requests of USB 2.0, chapter 9, as any device with such a profile answers them; whatever else is asked
/// for stalls. It remembers what the host has chosen, and which endpoints are halted.
class StandardRequests {
 public:
  explicit StandardRequests(Descriptors descriptors);

  ControlAnswer answer(const SetupPacket& setup);

  /// Whether an endpoint's packets go through: the host has chosen the configuration, and the endpoint is not halted.
  bool isOpen(std::uint8_t endpoint) const noexcept;
  const Descriptors& descriptors() const noexcept { return descriptors_; }
  /// As after a reset of the bus.
  void reset() noexcept;

 private:
  ControlAnswer read(const SetupPacket& setup) const;
  ControlAnswer status(std::uint8_t recipient, std::uint16_t index) const;
  ControlAnswer change(const SetupPacket& setup);
  /// Which of the profile's endpoints; none: it has no such.
  std::optional<std::size_t> find(std::uint16_t address) const noexcept;

  Descriptors descriptors_;
  std::vector<bool> halted_;  // a flag an endpoint
  std::uint8_t configuration_ = 0;
};

}  // namespace haptiv::usb
