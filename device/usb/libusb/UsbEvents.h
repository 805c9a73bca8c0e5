#pragma once

#include <poll.h>

#include <atomic>
#include <chrono>
#include <utility>
#include <vector>

#include "device/usb/libusb/UsbContext.h"

namespace haptiv::usb {

/// What a sleep can be ended by.
enum class Hearing {
  everything,
  notTransfers,  ///< those that have come back lie until the next wait that is ended
};

/// Waits for libusb's events, for a wake-up of one's own and for an alarm, in a single sleep. All callbacks run in
/// `wait`.
class UsbEvents {
 public:
  explicit UsbEvents(const UsbContext& context);
  ~UsbEvents();
  UsbEvents(const UsbEvents&) = delete;
  UsbEvents& operator=(const UsbEvents&) = delete;

  /// Sleeps until something happens, at most so long, and handles it; a wake-up comes first, and what else there is in
  /// the next wait. Thread: one.
  void wait(std::chrono::milliseconds most, Hearing hearing = Hearing::everything);
  /// Ends a wait once, so long from now; in place of an alarm that has not yet rung. Thread: the one that waits.
  void setAlarm(std::chrono::microseconds after) noexcept;
  /// Whether it has rung since the last call. Thread: the one that waits.
  bool rang() noexcept { return std::exchange(rang_, false); }
  /// The same for libusb's own events alone.
  void waitForTransfers();
  /// Ends a wait, now or the next one. Thread: any. Realtime-safe: one system call that never blocks; no lock.
  void wake() noexcept;

 private:
  void collect();
  void hear(Hearing hearing);
  bool handleOwn();
  void handleTransfers();

  const UsbContext& context_;
  int wakeUp_ = -1;  // eventfd
  int alarm_ = -1;   // timerfd
  bool rang_ = false;
  bool late_ = false;                 // transfers may be back that a wake-up went before
  std::vector<pollfd> descriptors_;   // the two, and libusb's
  std::atomic<bool> changed_ = true;  // libusb's descriptors
};

}  // namespace haptiv::usb
