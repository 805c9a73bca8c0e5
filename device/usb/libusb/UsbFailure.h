#pragma once

#include <stdexcept>
#include <string>

namespace haptiv::usb {

/// Why a USB device cannot be used.
enum class UsbTrouble {
  notFound,      ///< none is plugged in, or none with this serial number
  ambiguous,     ///< several are; the user has to say which
  noPermission,  ///< the udev rule is missing
  busy,          ///< another program holds it
  gone,          ///< it was unplugged while it was spoken to
  refused,       ///< it stalled a request
  silent,        ///< it did not answer in time
  wrongDevice,   ///< it speaks another version of the protocol, or drives another arm
  other,
};

/// What keeps a USB device from being used, in words: what, which device, what to do.
class UsbFailure : public std::runtime_error {
 public:
  UsbFailure(UsbTrouble trouble, const std::string& message) : std::runtime_error(message), trouble_(trouble) {}
  UsbTrouble trouble() const noexcept { return trouble_; }

 private:
  UsbTrouble trouble_;
};

/// The failure that an error code of libusb stands for.
/// @param doing   such as "open"
/// @param device  such as "the interface board B-0001 at bus 1, device 4"
UsbFailure failureOf(int code, const std::string& doing, const std::string& device);

/// Returns a result of libusb that is no error; throws failureOf for one that is.
int expectUsb(int result, const std::string& doing, const std::string& device);

}  // namespace haptiv::usb
