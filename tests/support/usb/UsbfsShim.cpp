// The functions of libc by which libusb reaches the kernel. Being defined in the executable, they come before libc's
// for the shared libraries too; what is not for the virtual bus goes on to the next library: umockdev, a sanitizer,
// libc.
#include "tests/support/usb/UsbfsShim.h"

#include <dlfcn.h>
#include <poll.h>

#include <cerrno>
#include <cstdarg>

#include "tests/support/usb/VirtualBus.h"

namespace haptiv::test {

namespace {

template <typename Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

/// A device's descriptor, or -1 with errno; nothing: the file is none of the bus's.
std::optional<int> openOnBus(const char* path) {
  VirtualBus* bus = VirtualBus::installed();
  const std::optional<int> opened = bus != nullptr ? bus->open(path) : std::nullopt;
  if (!opened || *opened >= 0) return opened;
  errno = -*opened;
  return -1;
}

/// Tells the watch when its thread ends.
struct ThreadsEnd {
  ~ThreadsEnd() { pollWatch().forget(std::this_thread::get_id()); }
};

}  // namespace

PollWatch& pollWatch() {
  static PollWatch& watch = *new PollWatch;  // never destroyed: umockdev's thread polls until the program has ended
  return watch;
}

int realPoll(pollfd* descriptors, nfds_t count, int timeout) {
  static const auto real = next<int (*)(pollfd*, nfds_t, int)>("poll");
  return real(descriptors, count, timeout);
}

int realClose(int descriptor) {
  static const auto real = next<int (*)(int)>("close");
  return real(descriptor);
}

}  // namespace haptiv::test

using haptiv::test::VirtualBus;

extern "C" {

int open(const char* path, int flags, ...) {
  static const auto real = haptiv::test::next<int (*)(const char*, int, ...)>("open");
  va_list more;
  va_start(more, flags);
  const int mode = va_arg(more, int);  // read only where libc reads it: O_CREAT
  va_end(more);
  const auto opened = haptiv::test::openOnBus(path);
  return opened ? *opened : real(path, flags, mode);
}

int __open_2(const char* path, int flags) {
  static const auto real = haptiv::test::next<int (*)(const char*, int)>("__open_2");
  const auto opened = haptiv::test::openOnBus(path);
  return opened ? *opened : real(path, flags);
}

int close(int descriptor) {
  if (VirtualBus* bus = VirtualBus::installed()) bus->closing(descriptor);
  return haptiv::test::realClose(descriptor);
}

int ioctl(int descriptor, unsigned long request, ...) noexcept {
  static const auto real = haptiv::test::next<int (*)(int, unsigned long, ...)>("ioctl");
  va_list more;
  va_start(more, request);
  void* argument = va_arg(more, void*);
  va_end(more);
  VirtualBus* bus = VirtualBus::installed();
  const std::optional<int> error = bus != nullptr ? bus->control(descriptor, request, argument) : std::nullopt;
  if (!error) return real(descriptor, request, argument);
  errno = *error;
  return *error == 0 ? 0 : -1;
}

int poll(pollfd* descriptors, nfds_t count, int timeout) {
  if (timeout == 0 || VirtualBus::installed() == nullptr) return haptiv::test::realPoll(descriptors, count, timeout);
  static thread_local const haptiv::test::ThreadsEnd end;
  (void)end;
  return haptiv::test::pollWatch().poll(descriptors, count, timeout);
}

}  // extern "C"
