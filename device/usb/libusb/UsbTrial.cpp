#include "device/usb/libusb/UsbTrial.h"

#include <libusb.h>

#include <memory>

namespace haptiv::usb {

std::optional<UsbFailure> troubleInUsing(const FoundUsb& found, const UsbKind& kind) {
  if (found.trouble) return found.trouble;
  libusb_device_handle* opened = nullptr;
  const int result = libusb_open(found.device.get(), &opened);
  if (result < 0) return failureOf(result, "open", found.describedAs(kind));
  const std::unique_ptr<libusb_device_handle, decltype(&libusb_close)> handle(opened, libusb_close);
  if (libusb_kernel_driver_active(opened, kind.interface) == 1) return std::nullopt;
  const int claimed = libusb_claim_interface(opened, kind.interface);
  if (claimed < 0) return failureOf(claimed, "use", found.describedAs(kind));
  libusb_release_interface(opened, kind.interface);
  return std::nullopt;
}

}  // namespace haptiv::usb
