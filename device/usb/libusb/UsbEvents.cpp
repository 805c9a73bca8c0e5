#include "device/usb/libusb/UsbEvents.h"

#include <libusb.h>
#include <sys/eventfd.h>
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

UsbEvents::UsbEvents(const UsbContext& context) : context_(context), wakeUp_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (wakeUp_ < 0) throw std::system_error(errno, std::generic_category(), "cannot wait for USB devices");
  libusb_set_pollfd_notifiers(context_.get(), added, removed, &changed_);
}

UsbEvents::~UsbEvents() {
  libusb_set_pollfd_notifiers(context_.get(), nullptr, nullptr, nullptr);
  close(wakeUp_);
}

void UsbEvents::collect() {
  if (!changed_.exchange(false)) return;
  descriptors_ = {{wakeUp_, POLLIN, 0}};
  const libusb_pollfd** list = libusb_get_pollfds(context_.get());
  for (const libusb_pollfd** at = list; at != nullptr && *at != nullptr; ++at)
    descriptors_.push_back({(*at)->fd, (*at)->events, 0});
  libusb_free_pollfds(list);
}

void UsbEvents::wait(std::chrono::milliseconds most) {
  collect();
  const int ready = poll(descriptors_.data(), descriptors_.size(), static_cast<int>(most.count()));
  if (ready <= 0) return;
  std::uint64_t times = 0;
  const bool woken = (descriptors_.front().revents & POLLIN) != 0;
  if (woken && read(wakeUp_, &times, sizeof times) < 0) return;  // nobody else reads it
  if (ready == 1 && woken) return;
  timeval none{};
  libusb_handle_events_timeout_completed(context_.get(), &none, nullptr);
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
