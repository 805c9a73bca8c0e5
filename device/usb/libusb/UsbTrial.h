#pragma once

#include <optional>

#include "device/usb/libusb/UsbFinder.h"

namespace haptiv::usb {

/// What would keep a program from using the device now: no permission, another program that holds its interface, or
/// that it has gone. Nothing is sent to it. A driver of the kernel gives way to whoever opens the device, so it is
/// none.
std::optional<UsbFailure> troubleInUsing(const FoundUsb& found, const UsbKind& kind);

}  // namespace haptiv::usb
