#include "device/usb/libusb/UsbContext.h"

#include <libusb.h>

#include "device/usb/libusb/UsbFailure.h"

namespace haptiv::usb {

UsbContext::UsbContext() {
  expectUsb(libusb_init(&context_), "look for", "USB devices");
  // What libusb would print, the failures tell.
  libusb_set_option(context_, LIBUSB_OPTION_LOG_LEVEL, LIBUSB_LOG_LEVEL_NONE);
}

UsbContext::~UsbContext() {
  libusb_exit(context_);
}

}  // namespace haptiv::usb
