#pragma once

struct libusb_context;

namespace haptiv::usb {

/// One use of libusb, independent of any other in the program. Its hot-plug thread is libusb's own.
class UsbContext {
 public:
  /// Throws UsbFailure where libusb cannot be started.
  UsbContext();
  ~UsbContext();
  UsbContext(const UsbContext&) = delete;
  UsbContext& operator=(const UsbContext&) = delete;

  libusb_context* get() const noexcept { return context_; }

 private:
  libusb_context* context_ = nullptr;
};

}  // namespace haptiv::usb
