#pragma once

#if defined(__has_feature)
#if __has_feature(realtime_sanitizer)
#define HAPTIV_REALTIME_SANITIZER 1
#include <sanitizer/rtsan_interface.h>
#endif
#endif

/// Stands behind the `noexcept` of a function of the servo path: neither it nor what it calls allocates, locks or makes
/// a system call. The preset rtsan ends the program where one does; to other compilers it says nothing.
#ifdef HAPTIV_REALTIME_SANITIZER
#define HAPTIV_NONBLOCKING [[clang::nonblocking]]
#else
#define HAPTIV_NONBLOCKING
#endif

namespace haptiv {

/// The one exception: while it lives, its thread talks to the arm, and may do what HAPTIV_NONBLOCKING forbids.
/// Only for a HapticDevice's own input and output.
class DeviceIo {
 public:
#ifdef HAPTIV_REALTIME_SANITIZER
  DeviceIo() noexcept {
    __rtsan_disable();
  }
  ~DeviceIo() {
    __rtsan_enable();
  }
#else
  DeviceIo() noexcept {}
  ~DeviceIo() {}
#endif
  DeviceIo(const DeviceIo&) = delete;
  DeviceIo& operator=(const DeviceIo&) = delete;
};

}  // namespace haptiv
