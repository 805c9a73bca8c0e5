#pragma once

#include <memory>

#include "device/usb/libusb/UsbContext.h"

struct libusb_device;

namespace haptiv::usb {

/// What has been plugged in and out, of any kind: libusb's callback leaves it here for the thread that handles its
/// events, on which, or on a thread of `findUsb` for which that one waits, it is called itself. Thread: that one.
class UsbHotPlug {
 public:
  /// Throws UsbFailure where libusb is not told.
  explicit UsbHotPlug(const UsbContext& context);
  ~UsbHotPlug();
  UsbHotPlug(const UsbHotPlug&) = delete;
  UsbHotPlug& operator=(const UsbHotPlug&) = delete;

  /// Whether libusb is told on this system; if not, look again.
  static bool isAvailable() noexcept;

  bool arrived = false;           ///< a device
  bool departed = false;          ///< a device
  bool left = false;              ///< `mine`
  libusb_device* mine = nullptr;  ///< null: none

 private:
  struct Registration;
  std::unique_ptr<Registration> registration_;
};

}  // namespace haptiv::usb
