#pragma once

#include <optional>
#include <span>

#include "tests/support/usb/UsbDescriptors.h"

namespace haptiv::test {

/// The eight bytes of a control request.
struct UsbSetup {
  std::uint8_t type = 0, request = 0;
  std::uint16_t value = 0, index = 0, length = 0;
};

/// A model of a USB device, to be plugged into a VirtualBus: any kind. Standard requests the bus answers itself, by the
/// descriptors; what is here is the device's own. The bus calls it under its lock, from whichever thread.
class VirtualUsbDevice {
 public:
  virtual ~VirtualUsbDevice() = default;

  virtual UsbDescriptors descriptors() const = 0;
  /// A class or vendor request that asks for data; nothing: a stall.
  virtual std::optional<Bytes> controlIn(const UsbSetup&) { return std::nullopt; }
  /// One that brings data; false: a stall.
  virtual bool controlOut(const UsbSetup&, std::span<const std::uint8_t>) { return false; }
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
