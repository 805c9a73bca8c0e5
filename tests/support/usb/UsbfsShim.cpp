// The functions of libc by which libusb reaches the kernel. Being defined in the executable, they come before libc's
// for the shared libraries too; what is not for the virtual bus goes on to the next library: umockdev, a sanitizer,
// libc. ThreadSanitizer itself opens and closes files while it writes a report, its locks held: for files that are none
// of the bus's no lock is taken here and nothing is done that it watches (this file is compiled without it).
#include "tests/support/usb/UsbfsShim.h"

#include <dlfcn.h>
#include <poll.h>
#include <pthread.h>
#include <sys/timerfd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <string_view>

#include "tests/support/usb/PollWatch.h"
#include "tests/support/usb/ShimTime.h"
#include "tests/support/usb/VirtualBus.h"

namespace haptiv::test {

namespace {

template <typename Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

/// The descriptors that the bus has a hand in: files open on it, timers that ring by it.
constinit std::array<std::atomic<bool>, 4096> busDescriptors{};

std::atomic<bool>* flagOf(int descriptor) {
  const auto at = static_cast<std::size_t>(descriptor);  // huge where it is negative
  return at < busDescriptors.size() ? &busDescriptors[at] : nullptr;
}

void adopt(int descriptor) {
  if (std::atomic<bool>* flag = flagOf(descriptor)) *flag = true;
}

/// Whether it was one of the bus's.
bool disown(int descriptor) {
  std::atomic<bool>* flag = flagOf(descriptor);
  return flag != nullptr && *flag && flag->exchange(false);
}

/// A device's descriptor, or -1 with errno; nothing: the file is none of the bus's.
std::optional<int> openOnBus(const char* path) {
  if (!std::string_view(path).starts_with("/dev/bus/usb/")) return std::nullopt;
  VirtualBus* bus = VirtualBus::installed();
  const std::optional<int> opened = bus != nullptr ? bus->open(path) : std::nullopt;
  if (!opened) return opened;
  if (*opened >= 0) {
    adopt(*opened);
    return opened;
  }
  errno = -*opened;
  return -1;
}

/// Zero, or the error number; nothing: the file is none of the bus's.
std::optional<int> askBus(int descriptor, unsigned long request, void* argument) {
  const ShimTime time;
  VirtualBus* bus = VirtualBus::installed();
  return bus != nullptr ? bus->control(descriptor, request, argument) : std::nullopt;
}

int realSetTime(int timer, int flags, const itimerspec* value, itimerspec* before) {
  static const auto real = next<int (*)(int, int, const itimerspec*, itimerspec*)>("timerfd_settime");
  return real(timer, flags, value, before);
}

/// libusb's threads do nothing but wait for events; one that has just been started has missed none of them.
bool isLibusb(const void* caller) {
  Dl_info info{};
  return dladdr(caller, &info) != 0 && std::string_view(info.dli_fname).find("libusb") != std::string_view::npos;
}

/// Tells the watch when its thread ends.
struct ThreadsEnd {
  ~ThreadsEnd() { pollWatch().forget(std::this_thread::get_id()); }
};

}  // namespace

int realPoll(pollfd* descriptors, nfds_t count, int timeout) {
  static const auto real = next<int (*)(pollfd*, nfds_t, int)>("poll");
  return real(descriptors, count, timeout);
}

int realClose(int descriptor) {
  static const auto real = next<int (*)(int)>("close");
  return real(descriptor);
}

void realRing(int timer) {
  constexpr itimerspec kAtOnce{{}, {0, 1}};
  realSetTime(timer, 0, &kAtOnce, nullptr);
  itimerspec left = kAtOnce;
  while (left.it_value.tv_sec != 0 || left.it_value.tv_nsec != 0) timerfd_gettime(timer, &left);
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
  VirtualBus* bus = VirtualBus::installed();
  if (haptiv::test::disown(descriptor) && bus != nullptr) bus->closing(descriptor);
  return haptiv::test::realClose(descriptor);
}

int ioctl(int descriptor, unsigned long request, ...) noexcept {
  static const auto real = haptiv::test::next<int (*)(int, unsigned long, ...)>("ioctl");
  va_list more;
  va_start(more, request);
  void* argument = va_arg(more, void*);
  va_end(more);
  const std::optional<int> error = haptiv::test::askBus(descriptor, request, argument);
  if (!error) return real(descriptor, request, argument);
  errno = *error;
  return *error == 0 ? 0 : -1;
}

int timerfd_settime(int timer, int flags, const itimerspec* value, itimerspec* before) noexcept {
  const std::int64_t after = value->it_value.tv_sec * 1'000'000 + value->it_value.tv_nsec / 1000;
  VirtualBus* bus = VirtualBus::installed();
  if (flags != 0 || after == 0 || bus == nullptr || !bus->setAlarm(timer, after))
    return haptiv::test::realSetTime(timer, flags, value, before);
  haptiv::test::adopt(timer);
  constexpr itimerspec kNever{};
  return haptiv::test::realSetTime(timer, 0, &kNever, before);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* argument) noexcept {
  static const auto real =
      haptiv::test::next<int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)>("pthread_create");
  const int error = real(thread, attributes, run, argument);
  if (error == 0 && haptiv::test::isLibusb(__builtin_return_address(0)))
    haptiv::test::pollWatch().expect(std::thread::id(*thread));
  return error;
}

int poll(pollfd* descriptors, nfds_t count, int timeout) {
  if (timeout == 0 || VirtualBus::installed() == nullptr) return haptiv::test::realPoll(descriptors, count, timeout);
  static thread_local const haptiv::test::ThreadsEnd end;
  (void)end;
  return haptiv::test::pollWatch().poll(descriptors, count, timeout);
}

}  // extern "C"
