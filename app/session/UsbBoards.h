#pragma once

#include <functional>
#include <memory>
#include <string>

#include "device/usb/UsbDevice.h"

namespace haptiv {

/// Whether a device by its name, as after `--device`, is an interface board: "usb", or "usb:WHICH".
bool isBoard(const std::string& device);
/// The serial number or port in it; empty: the only board there is.
std::string boardSerialOf(const std::string& device);
/// What makes the device for a session.
std::function<std::unique_ptr<HapticDevice>()> boardOf(const std::string& device, const DeviceDescription& description);

}  // namespace haptiv
