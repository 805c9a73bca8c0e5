#include "device/usb/libusb/UsbEvents.h"

#include <libusb.h>
#include <sys/eventfd.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace haptiv::usb {

namespace {

void added(int, short, void* changed) {
  *static_cast<std::atomic<bool>*>(changed) = true;
}
void removed(int, void* changed) {
  *static_cast<std::atomic<bool>*>(changed) = true;
}

}  // namespace

UsbEvents::UsbEvents(const UsbContext& context)
    : context_(context),
      wakeUp_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      alarm_(timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK)) {
  if (wakeUp_ < 0 || alarm_ < 0) {
    const int error = errno;
    if (wakeUp_ >= 0) close(wakeUp_);
    throw std::system_error(error, std::generic_category(), "cannot wait for USB devices");
  }
  libusb_set_pollfd_notifiers(context_.get(), added, removed, &changed_);
}

UsbEvents::~UsbEvents() {
  libusb_set_pollfd_notifiers(context_.get(), nullptr, nullptr, nullptr);
  close(alarm_);
  close(wakeUp_);
}

void UsbEvents::collect() {
  if (!changed_.exchange(false)) return;
  descriptors_ = {{wakeUp_, POLLIN, 0}, {alarm_, POLLIN, 0}};
  const libusb_pollfd** list = libusb_get_pollfds(context_.get());
  for (const libusb_pollfd** at = list; at != nullptr && *at != nullptr; ++at)
    descriptors_.push_back({(*at)->fd, (*at)->events, 0});
  libusb_free_pollfds(list);
}

/// A device's file says POLLOUT when a transfer is back. Poll passes over what is negative: the complement of a
/// descriptor. Not asked for, POLLOUT would still wake the thread for each, to find that it goes back to sleep.
void UsbEvents::hear(Hearing hearing) {
  for (pollfd& each : descriptors_)
    if ((each.events & POLLOUT) != 0 && (each.fd < 0) != (hearing == Hearing::notTransfers)) each.fd = ~each.fd;
}

/// Whether it was woken.
bool UsbEvents::handleOwn() {
  std::uint64_t times = 0;
  const bool woken = (descriptors_[0].revents & POLLIN) != 0 && ::read(wakeUp_, &times, sizeof times) > 0;
  if ((descriptors_[1].revents & POLLIN) != 0 && ::read(alarm_, &times, sizeof times) > 0) rang_ = true;
  return woken;
}

void UsbEvents::handleTransfers() {
  timeval none{};
  libusb_handle_events_timeout_completed(context_.get(), &none, nullptr);
}

void UsbEvents::wait(std::chrono::milliseconds most, Hearing hearing) {
  if (std::exchange(late_, false)) return handleTransfers();
  collect();
  hear(hearing);
  const int ready = poll(descriptors_.data(), descriptors_.size(), static_cast<int>(most.count()));
  if (ready <= 0) return;
  if (!handleOwn()) return handleTransfers();
  late_ = ready > 1 || hearing == Hearing::notTransfers;
}

void UsbEvents::setAlarm(std::chrono::microseconds after) noexcept {
  itimerspec once{};
  once.it_value.tv_sec = after.count() / 1'000'000;
  once.it_value.tv_nsec = after.count() % 1'000'000 * 1000;
  timerfd_settime(alarm_, 0, &once, nullptr);
}

void UsbEvents::waitForTransfers() {
  timeval some{0, 100'000};
  libusb_handle_events_timeout_completed(context_.get(), &some, nullptr);
}

void UsbEvents::wake() noexcept {
  const std::uint64_t once = 1;
  [[maybe_unused]] const auto written = write(wakeUp_, &once, sizeof once);  // full: it is awake anyway
}

}  // namespace haptiv::usb
