#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "device/usb/libusb/UsbHandle.h"

struct libusb_transfer;

namespace haptiv::usb {

enum class TransferKind { interrupt, bulk };

/// How a transfer came back.
enum class TransferEnd {
  done,
  stalled,
  tooLong,  ///< the device sent more than there was room for (babble, overflow)
  error,    ///< damaged on the wire
  cancelled,
  gone,  ///< the device has left
};

/// One transfer with its buffer, used again and again, without a time limit.
/// Thread: the one that handles libusb's events.
class UsbTransfer {
 public:
  /// @param done  called each time it is back; not for submit's own failure
  UsbTransfer(UsbHandle& handle, TransferKind kind, std::uint8_t endpoint, std::size_t size,
              std::function<void(UsbTransfer&)> done);
  /// It must be back.
  ~UsbTransfer();
  UsbTransfer(const UsbTransfer&) = delete;
  UsbTransfer& operator=(const UsbTransfer&) = delete;

  /// Sends it on its way with `length` bytes to write, or to read at most. `done`: it is on its way.
  TransferEnd submit(std::size_t length) noexcept;
  void cancel() noexcept;

  bool inFlight() const noexcept { return inFlight_; }
  std::size_t size() const noexcept { return buffer_.size(); }
  std::span<std::uint8_t> buffer() noexcept { return buffer_; }
  TransferEnd end() const noexcept;                      ///< of the last journey
  std::span<const std::uint8_t> bytes() const noexcept;  ///< that came, or went

 private:
  friend struct TransferCallback;

  std::vector<std::uint8_t> buffer_;
  std::function<void(UsbTransfer&)> done_;
  libusb_transfer* transfer_;
  bool inFlight_ = false;
};

}  // namespace haptiv::usb
