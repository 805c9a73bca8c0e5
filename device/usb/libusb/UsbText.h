#pragma once

#include <chrono>
#include <cstdint>
#include <string>

struct libusb_device_handle;

namespace haptiv::usb {

/// By when a device answers that is asked who it is: what USB 2.0 (9.2.6.4) leaves it for a packet of its answer.
inline constexpr std::chrono::milliseconds kAnswerLimit{500};

/// It has not answered within the limit.
struct SilentDevice {};

/// A string descriptor, in the device's first language; empty where there is none. What is not printable ASCII becomes
/// '?'. Throws SilentDevice.
std::string textOf(libusb_device_handle* handle, std::uint8_t index);

}  // namespace haptiv::usb
