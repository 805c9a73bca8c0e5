#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "device/usb/libusb/UsbFinder.h"

struct libusb_device_handle;

namespace haptiv::usb {

/// The head of a control request.
struct UsbRequest {
  std::uint8_t type = 0;  ///< bmRequestType, with the direction
  std::uint8_t request = 0;
  std::uint16_t value = 0;
  std::uint16_t index = 0;
};

/// A device that is open, with its interface claimed; a driver of the kernel that held it gets it back at the end.
/// Thread: one at a time. Control requests wait for their answer, for as long as `patience`: never for the servo, nor
/// while a stream runs on the handle.
class UsbHandle {
 public:
  static constexpr std::chrono::milliseconds kPatience{1000};

  /// Throws UsbFailure.
  UsbHandle(const FoundUsb& found, const UsbKind& kind, std::chrono::milliseconds patience = kPatience);
  /// No transfer may be on its way.
  ~UsbHandle();
  UsbHandle(const UsbHandle&) = delete;
  UsbHandle& operator=(const UsbHandle&) = delete;

  /// What the device answers, at most so many bytes. Throws UsbFailure; `doing` is for its message, such as "ask for
  /// its name".
  std::vector<std::uint8_t> controlIn(const UsbRequest& request, std::size_t most, const std::string& doing);
  /// Throws UsbFailure.
  void controlOut(const UsbRequest& request, std::span<const std::uint8_t> bytes, const std::string& doing);

  /// Bytes of the largest packet of an endpoint. Throws UsbFailure where there is no such endpoint.
  int maxPacketSize(std::uint8_t endpoint) const;
  /// Ends a stall. False: it could not be.
  bool clearHalt(std::uint8_t endpoint) noexcept;

  libusb_device_handle* get() const noexcept { return handle_; }
  const FoundUsb& found() const noexcept { return found_; }
  const std::string& name() const noexcept { return name_; }  ///< for messages

 private:
  FoundUsb found_;
  std::string name_;
  int interface_;
  unsigned patience_;  // [ms]
  libusb_device_handle* handle_ = nullptr;
};

}  // namespace haptiv::usb
