#pragma once

#include <poll.h>

#include <atomic>
#include <chrono>
#include <vector>

#include "device/usb/libusb/UsbContext.h"

namespace haptiv::usb {

/// Waits for libusb's events and for a wake-up of one's own, in a single sleep. All callbacks run in `wait`.
class UsbEvents {
 public:
  explicit UsbEvents(const UsbContext& context);
  ~UsbEvents();
  UsbEvents(const UsbEvents&) = delete;
  UsbEvents& operator=(const UsbEvents&) = delete;

  /// Sleeps until something happens, at most so long, and handles it. Thread: one.
  void wait(std::chrono::milliseconds most);
  /// The same for libusb's own events alone.
  void waitForTransfers();
  /// Ends a wait, now or the next one. Thread: any. Realtime-safe: one system call that never blocks; no lock.
  void wake() noexcept;

 private:
  void collect();

  const UsbContext& context_;
  int wakeUp_ = -1;  // eventfd
  std::vector<pollfd> descriptors_;
  std::atomic<bool> changed_ = true;  // libusb's descriptors
};

}  // namespace haptiv::usb
