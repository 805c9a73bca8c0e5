#include "device/usb/falcon/SerialPort.h"

#include <array>

namespace haptiv::falcon {

FtdiValue ftdiDivisor(unsigned baud) noexcept {
  constexpr unsigned kClock = 3'000'000;                                  // [Hz]
  constexpr std::array<unsigned, 8> kEighths = {0, 3, 2, 4, 1, 5, 6, 7};  // how the chip writes 0/8 to 7/8
  const unsigned eighths = (8 * kClock + baud / 2) / baud;
  if (eighths == 8) return {0, 0};   // 3 MHz, and ...
  if (eighths == 12) return {1, 0};  // ... 2 MHz have a number of their own
  const unsigned code = kEighths[eighths % 8];
  return {static_cast<std::uint16_t>((eighths / 8 & 0x3FFF) | (code & 3) << 14), static_cast<std::uint16_t>(code >> 2)};
}

}  // namespace haptiv::falcon
