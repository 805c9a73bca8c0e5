#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

namespace haptiv::falcon {

/// The Falcon's serial chip while it is set up, an FT232 of FTDI's: requests to the chip, and bytes to and from what is
/// behind it. Waits; not for the servo. Throws std::runtime_error where the device is gone.
class SerialPort {
 public:
  virtual ~SerialPort() = default;

  /// A request without data to the chip: Ftdi says which.
  virtual void control(std::uint8_t request, std::uint16_t value, std::uint16_t index) = 0;
  virtual void send(std::span<const std::uint8_t> bytes) = 0;
  /// `count` bytes, without the chip's status; fewer where they have not come in time.
  virtual std::vector<std::uint8_t> receive(std::size_t count, std::chrono::milliseconds timeout) = 0;
};

/// Requests of the chip, of vendor type, to the device.
enum class Ftdi : std::uint8_t { reset = 0, modem = 1, flow = 2, baud = 3, data = 4, latency = 9 };

/// Value and index of a request.
struct FtdiValue {
  std::uint16_t value;
  std::uint16_t index;
  bool operator==(const FtdiValue&) const = default;
};

/// For Ftdi::baud: the chip divides 3 MHz by a number with eighths. `baud` is 200 to 3,000,000.
FtdiValue ftdiDivisor(unsigned baud) noexcept;

}  // namespace haptiv::falcon
