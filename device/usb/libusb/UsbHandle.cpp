#include "device/usb/libusb/UsbHandle.h"

#include <libusb.h>

#include "device/usb/libusb/UsbFailure.h"

namespace haptiv::usb {

UsbHandle::UsbHandle(const FoundUsb& found, const UsbKind& kind, std::chrono::milliseconds patience)
    : found_(found),
      name_(found.describedAs(kind)),
      interface_(kind.interface),
      patience_(static_cast<unsigned>(patience.count())) {
  expectUsb(libusb_open(found_.device.get(), &handle_), "open", name_);
  libusb_set_auto_detach_kernel_driver(handle_, 1);
  const int claimed = libusb_claim_interface(handle_, interface_);
  if (claimed < 0) {
    libusb_close(handle_);
    throw failureOf(claimed, "use", name_);
  }
}

UsbHandle::~UsbHandle() {
  libusb_release_interface(handle_, interface_);
  libusb_close(handle_);
}

std::vector<std::uint8_t> UsbHandle::controlIn(const UsbRequest& request, std::size_t most, const std::string& doing) {
  std::vector<std::uint8_t> bytes(most);
  const int length = libusb_control_transfer(handle_, request.type, request.request, request.value, request.index,
                                             bytes.data(), static_cast<std::uint16_t>(most), patience_);
  bytes.resize(static_cast<std::size_t>(expectUsb(length, doing, name_)));
  return bytes;
}

void UsbHandle::controlOut(const UsbRequest& request, std::span<const std::uint8_t> bytes, const std::string& doing) {
  std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());  // libusb asks for bytes that may be written
  const int length = libusb_control_transfer(handle_, request.type, request.request, request.value, request.index,
                                             copy.data(), static_cast<std::uint16_t>(copy.size()), patience_);
  if (expectUsb(length, doing, name_) != static_cast<int>(bytes.size()))
    throw UsbFailure(UsbTrouble::other, "cannot " + doing + " " + name_ + ": it took a part of the request only");
}

int UsbHandle::maxPacketSize(std::uint8_t endpoint) const {
  return expectUsb(libusb_get_max_packet_size(found_.device.get(), endpoint), "use an endpoint of", name_);
}

bool UsbHandle::clearHalt(std::uint8_t endpoint) noexcept {
  return libusb_clear_halt(handle_, endpoint) == LIBUSB_SUCCESS;
}

}  // namespace haptiv::usb
