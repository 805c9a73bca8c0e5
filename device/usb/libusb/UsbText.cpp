#include "device/usb/libusb/UsbText.h"

#include <libusb.h>

#include <algorithm>
#include <array>
#include <span>

namespace haptiv::usb {

namespace {

constexpr std::size_t kHead = 2;  // length and type

/// What stands behind the head, cut to whole characters of two bytes; empty where there is no such descriptor.
std::span<const unsigned char> read(libusb_device_handle* handle, unsigned index, unsigned language,
                                    std::span<unsigned char> room) {
  const int length = libusb_control_transfer(
      handle, LIBUSB_ENDPOINT_IN, LIBUSB_REQUEST_GET_DESCRIPTOR,
      static_cast<std::uint16_t>(LIBUSB_DT_STRING << 8 | index), static_cast<std::uint16_t>(language), room.data(),
      static_cast<std::uint16_t>(room.size()), static_cast<unsigned>(kAnswerLimit.count()));
  if (length == LIBUSB_ERROR_TIMEOUT) throw SilentDevice();
  if (length < static_cast<int>(kHead) || room[1] != LIBUSB_DT_STRING || room[0] < kHead) return {};
  const std::size_t told = std::min<std::size_t>(room[0], static_cast<std::size_t>(length));
  return room.subspan(kHead, (told - kHead) / 2 * 2);
}

}  // namespace

std::string textOf(libusb_device_handle* handle, std::uint8_t index) {
  if (index == 0) return {};
  std::array<unsigned char, 255> room{};
  const auto languages = read(handle, 0, 0, room);
  if (languages.empty()) return {};
  const unsigned language = languages[0] | static_cast<unsigned>(languages[1]) << 8;
  std::string text;
  const auto characters = read(handle, index, language, room);  // UTF-16LE
  for (std::size_t i = 0; i < characters.size(); i += 2) {
    const bool isPrintable = characters[i + 1] == 0 && characters[i] >= ' ' && characters[i] <= '~';
    text += isPrintable ? static_cast<char>(characters[i]) : '?';
  }
  return text;
}

}  // namespace haptiv::usb
