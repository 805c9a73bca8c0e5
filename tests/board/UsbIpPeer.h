#pragma once

#include "app/board/usbip/Messages.h"

namespace haptiv::test {

/// The importing side of USB/IP, as the kernel's vhci_hcd speaks it: what it sends, written independently of the
/// server.
class UsbIpWords {
 public:
  static usbip::Bytes list() { return {0x01, 0x11, 0x80, 0x05, 0, 0, 0, 0}; }
  static usbip::Bytes import(const std::string& busId) {
    usbip::Bytes bytes{0x01, 0x11, 0x80, 0x03, 0, 0, 0, 0};
    bytes.insert(bytes.end(), busId.begin(), busId.end());
    bytes.resize(40);
    return bytes;
  }
  static usbip::Bytes urb(std::uint32_t sequence, bool in, std::uint32_t endpoint, std::uint32_t length,
                          const std::array<std::uint8_t, 8>& setup = {}, const usbip::Bytes& data = {}) {
    usbip::Bytes bytes;
    for (const std::uint32_t word : {1u, sequence, 0x10002u, in ? 1u : 0u, endpoint, 0u, length, 0u, 0xffffffffu, 1u})
      append(bytes, word);
    bytes.insert(bytes.end(), setup.begin(), setup.end());
    bytes.insert(bytes.end(), data.begin(), data.end());
    return bytes;
  }
  static usbip::Bytes unlink(std::uint32_t sequence, std::uint32_t victim) {
    usbip::Bytes bytes;
    for (const std::uint32_t word : {2u, sequence, 0x10002u, 0u, 0u, victim}) append(bytes, word);
    bytes.resize(48);
    return bytes;
  }
  /// GET_DESCRIPTOR and SET_CONFIGURATION.
  static usbip::Bytes descriptor(std::uint32_t sequence, std::uint8_t type, std::uint8_t index, std::uint8_t length) {
    return urb(sequence, true, 0, length, {0x80, 6, index, type, 0, 0, length, 0});
  }
  static usbip::Bytes configure(std::uint32_t sequence) { return urb(sequence, false, 0, 0, {0, 9, 1, 0, 0, 0, 0, 0}); }

  static std::uint32_t word(const usbip::Bytes& bytes, std::size_t at) {
    return std::uint32_t{bytes.at(at)} << 24 | std::uint32_t{bytes.at(at + 1)} << 16 |
           std::uint32_t{bytes.at(at + 2)} << 8 | bytes.at(at + 3);
  }

 private:
  static void append(usbip::Bytes& bytes, std::uint32_t word) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(word >> shift));
  }
};

}  // namespace haptiv::test
