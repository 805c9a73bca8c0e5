#pragma once

#include "device/usb/protocol/Descriptors.h"
#include "device/usb/protocol/SetupPacket.h"

namespace haptiv::test {

using Bytes = std::vector<std::uint8_t>;
using usb::UsbSpeed;

/// A model of a USB device, to be plugged into a VirtualBus: any kind. The bus calls it under its lock, from whichever
/// thread.
class VirtualUsbDevice {
 public:
  virtual ~VirtualUsbDevice() = default;

  virtual const usb::Descriptors& descriptors() const = 0;
  /// A control request, standard ones too (usb::StandardRequests has their answers).
  virtual usb::ControlAnswer answer(const usb::SetupPacket& setup, std::span<const std::uint8_t> data) = 0;
  /// Whether an endpoint's packets go through: it is configured, and not halted.
  virtual bool isOpen(std::uint8_t endpoint) const = 0;
  /// The host asks an IN endpoint for a packet, once an interval; nothing: it has none now.
  virtual std::optional<Bytes> packetIn(std::uint8_t endpoint) = 0;
  /// A packet has come to an OUT endpoint, at most one an interval.
  virtual void packetOut(std::uint8_t endpoint, std::span<const std::uint8_t> packet) = 0;
  /// Time goes on by one interval of the bus [us]: 125 at high speed, 1000 at full speed. Between the interval's OUT
  /// and IN packets.
  virtual void advance(std::int64_t interval) = 0;
  /// It is plugged in, or out. One that lives by the cable's power forgets everything here.
  virtual void powered(bool) {}
};

}  // namespace haptiv::test
