#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

#include "device/usb/libusb/UsbTransfer.h"

namespace haptiv::usb {

/// Which endpoints carry a device's packets, and how.
struct StreamEndpoints {
  TransferKind kind = TransferKind::interrupt;
  std::uint8_t in = 0x81;
  std::size_t inSize = 64;  ///< bytes of the longest packet
  std::uint8_t out = 0;     ///< 0: nothing is ever sent
  std::size_t outSize = 64;
  int ahead = 4;  ///< IN transfers that are on their way at any time, so that the bus never waits for the host
  /// After a packet has gone out, for so long what comes in is left to gather, and is then taken in one go: each
  /// wake-up of a thread costs more than what it does. 0: each packet is taken as it comes.
  std::chrono::microseconds rest{0};
};

/// What knows one kind of device: makes it ready, takes its packets, has packets for it. UsbLink calls all of it: the
/// first `prepare` on the thread that opens the link, everything else on the link's own.
class UsbClient {
 public:
  virtual ~UsbClient() = default;

  /// The device has been opened: the place for control requests. Throws UsbFailure where it cannot be used.
  virtual StreamEndpoints prepare(UsbHandle& handle) = 0;
  /// A packet has come in, of any length up to inSize.
  virtual void received(std::span<const std::uint8_t> packet) noexcept = 0;
  /// A packet did not come in or go out: stalled, tooLong or error.
  virtual void faulted(TransferEnd end) noexcept = 0;
  /// Writes the newest packet to send and returns its length; 0: nothing new.
  virtual std::size_t send(std::span<std::uint8_t> packet) noexcept = 0;
  /// Something that comes in is waited for: no rest now.
  virtual bool awaits() const noexcept { return false; }
  /// The device has not yet taken the two packets before: what `send` would send next is not to be sent.
  virtual void skip() noexcept = 0;
  /// The device has left, or has failed for good: no packet comes any more until the next `prepare`.
  virtual void lost() noexcept = 0;
};

}  // namespace haptiv::usb
