#pragma once

#include <array>
#include <memory>
#include <vector>

#include "device/usb/libusb/UsbClient.h"

namespace haptiv::usb {

/// Packets in and out of one open device. IN transfers are always on their way; two OUT transfers are there for use,
/// and where both are, the packet is skipped: what is old is never queued.
///
/// A stall is cleared, a damaged or too long packet is let go; after kMostFaults in a row, of either direction, the
/// stream gives up. Thread: the one that handles libusb's events.
class UsbStream {
 public:
  static constexpr int kMostFaults = 100;

  UsbStream(UsbHandle& handle, const StreamEndpoints& endpoints, UsbClient& client);
  /// It must be idle.
  ~UsbStream() = default;

  void start() noexcept;
  /// Sends what the client has, if there is something new; whether it did.
  bool send() noexcept;
  /// Nothing that comes in is wanted yet, until `endRest`: since something was sent, StreamEndpoints::rest ago at most.
  bool rests() const noexcept;
  void endRest() noexcept { resting_ = false; }
  std::chrono::microseconds rest() const noexcept { return endpoints_.rest; }
  /// Clears stalls: no work for a callback.
  void recover() noexcept;
  /// The device has left, or does nothing but fail.
  bool lost() const noexcept { return lost_; }
  void lose() noexcept { lost_ = true; }

  /// Asks every transfer back; `idle` once all of them are.
  void cancel() noexcept;
  bool idle() const noexcept;

 private:
  using Slot = std::unique_ptr<UsbTransfer>;

  void back(UsbTransfer& transfer, bool in) noexcept;
  bool take(const UsbTransfer& transfer, int& faults) noexcept;
  void listen(UsbTransfer& transfer) noexcept;

  UsbHandle& handle_;
  StreamEndpoints endpoints_;
  UsbClient& client_;
  std::vector<Slot> in_;
  std::array<Slot, 2> out_;           // empty where the device takes none
  int inFaults_ = 0, outFaults_ = 0;  // in a row
  bool inStalled_ = false, outStalled_ = false;
  bool resting_ = false;
  bool closing_ = false;
  bool lost_ = false;
};

}  // namespace haptiv::usb
