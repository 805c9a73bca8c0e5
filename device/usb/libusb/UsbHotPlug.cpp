#include "device/usb/libusb/UsbHotPlug.h"

#include <libusb.h>

#include "device/usb/libusb/UsbFailure.h"

namespace haptiv::usb {

struct UsbHotPlug::Registration {
  static int LIBUSB_CALL told(libusb_context*, libusb_device* device, libusb_hotplug_event event, void* self) {
    auto& plug = *static_cast<UsbHotPlug*>(self);
    if (event == LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED) plug.arrived = true;
    if (event == LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT) plug.departed = true;
    if (event == LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT && device == plug.mine) plug.left = true;
    return 0;
  }

  libusb_context* context;
  libusb_hotplug_callback_handle handle{};
};

UsbHotPlug::UsbHotPlug(const UsbContext& context) : registration_(std::make_unique<Registration>()) {
  registration_->context = context.get();
  constexpr int kEvents = LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT;
  expectUsb(
      libusb_hotplug_register_callback(context.get(), kEvents, 0, LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY,
                                       LIBUSB_HOTPLUG_MATCH_ANY, Registration::told, this, &registration_->handle),
      "watch for", "USB devices");
}

UsbHotPlug::~UsbHotPlug() {
  libusb_hotplug_deregister_callback(registration_->context, registration_->handle);
}

bool UsbHotPlug::isAvailable() noexcept {
  return libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG) != 0;
}

}  // namespace haptiv::usb
