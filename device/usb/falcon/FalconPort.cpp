#include "device/usb/falcon/FalconPort.h"

#include <libusb.h>

#include <algorithm>
#include <array>

#include "device/usb/falcon/FalconStream.h"
#include "device/usb/libusb/UsbFailure.h"

namespace haptiv::falcon {
namespace {

constexpr std::uint8_t kVendorRequest = 0x40;  // to the device
constexpr unsigned kPatience = 1000;           // [ms]

}  // namespace

usb::UsbKind usbKind() {
  return {"Novint Falcon", {{0x0403, 0xcb48}}, 0};
}

void Port::control(std::uint8_t request, std::uint16_t value, std::uint16_t index) {
  handle_.controlOut({kVendorRequest, request, value, index}, {}, "set up the serial chip of");
}

void Port::send(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());  // libusb asks for bytes that may be written
  int sent = 0;
  const int result =
      libusb_bulk_transfer(handle_.get(), kOutEndpoint, copy.data(), static_cast<int>(copy.size()), &sent, kPatience);
  usb::expectUsb(result, "send to", handle_.name());
  if (sent != static_cast<int>(copy.size()))
    throw usb::UsbFailure(usb::UsbTrouble::other, "cannot send to " + handle_.name() + ": it took a part only");
}

/// One packet: the chip tells its status alone each few milliseconds where there is nothing else.
void Port::receiveOnce(unsigned timeout) {
  std::array<std::uint8_t, Stream::kUsbPacket> packet{};
  int length = 0;
  const int result = libusb_bulk_transfer(handle_.get(), kInEndpoint, packet.data(), static_cast<int>(packet.size()),
                                          &length, timeout);
  if (result != LIBUSB_ERROR_TIMEOUT) usb::expectUsb(result, "receive from", handle_.name());
  if (length > static_cast<int>(Stream::kStatus))
    come_.insert(come_.end(), packet.begin() + Stream::kStatus, packet.begin() + length);
}

std::vector<std::uint8_t> Port::receive(std::size_t count, std::chrono::milliseconds timeout) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + timeout;
  for (auto now = Clock::now(); come_.size() < count && now < end; now = Clock::now()) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - now).count();
    receiveOnce(static_cast<unsigned>(std::max<std::int64_t>(left, 1)));  // 0 would be for ever
  }
  const auto last = come_.begin() + static_cast<std::ptrdiff_t>(std::min(count, come_.size()));
  const std::vector<std::uint8_t> bytes(come_.begin(), last);
  come_.erase(come_.begin(), last);
  return bytes;
}

}  // namespace haptiv::falcon
