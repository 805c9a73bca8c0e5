#include "device/usb/libusb/UsbFailure.h"

#include <libusb.h>

namespace haptiv::usb {

namespace {

UsbTrouble troubleOf(int code) {
  switch (code) {
    case LIBUSB_ERROR_ACCESS:
      return UsbTrouble::noPermission;
    case LIBUSB_ERROR_BUSY:
      return UsbTrouble::busy;
    case LIBUSB_ERROR_NO_DEVICE:
    case LIBUSB_ERROR_NOT_FOUND:
      return UsbTrouble::gone;
    case LIBUSB_ERROR_PIPE:
      return UsbTrouble::refused;
    case LIBUSB_ERROR_TIMEOUT:
      return UsbTrouble::silent;
    default:
      return UsbTrouble::other;
  }
}

std::string remedyOf(UsbTrouble trouble) {
  switch (trouble) {
    case UsbTrouble::noPermission:
      return "no permission. Install the udev rule and plug the device in again: sudo cp device/usb/60-haptiv.rules "
             "/etc/udev/rules.d/ && sudo udevadm control --reload";
    case UsbTrouble::busy:
      return "another program holds it: close that one first";
    case UsbTrouble::gone:
      return "it is not there any more: plug it in and try again";
    case UsbTrouble::refused:
      return "the device refused it";
    case UsbTrouble::silent:
      return "the device does not answer: switch it off and on";
    default:
      return {};
  }
}

}  // namespace

UsbFailure failureOf(int code, const std::string& doing, const std::string& device) {
  const UsbTrouble trouble = troubleOf(code);
  std::string remedy = remedyOf(trouble);
  if (remedy.empty()) remedy = std::string(libusb_strerror(code)) + ": plug it in again, or try another port";
  return {trouble, "cannot " + doing + " " + device + ": " + remedy};
}

int expectUsb(int result, const std::string& doing, const std::string& device) {
  if (result < 0) throw failureOf(result, doing, device);
  return result;
}

}  // namespace haptiv::usb
