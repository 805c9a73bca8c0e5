#pragma once

#include <deque>

#include "device/usb/falcon/SerialPort.h"
#include "device/usb/libusb/UsbHandle.h"

namespace haptiv::falcon {

inline constexpr std::uint8_t kInEndpoint = 0x81, kOutEndpoint = 0x02;  ///< both bulk

/// How it is found.
usb::UsbKind usbKind();

/// The serial chip over an open USB device that no stream runs on. Throws usb::UsbFailure.
class Port : public SerialPort {
 public:
  explicit Port(usb::UsbHandle& handle) : handle_(handle) {}

  void control(std::uint8_t request, std::uint16_t value, std::uint16_t index) override;
  void send(std::span<const std::uint8_t> bytes) override;
  std::vector<std::uint8_t> receive(std::size_t count, std::chrono::milliseconds timeout) override;

 private:
  void receiveOnce(unsigned timeout);

  usb::UsbHandle& handle_;
  std::deque<std::uint8_t> come_;  // and not yet asked for
};

}  // namespace haptiv::falcon
