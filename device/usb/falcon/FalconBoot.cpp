#include "device/usb/falcon/FalconBoot.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include "device/usb/falcon/FalconFirmware.h"
#include "device/usb/falcon/FalconPackets.h"

namespace haptiv::falcon {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;

constexpr int kAttempts = 3;
constexpr unsigned kAskingBaud = 9600, kLoadingBaud = 140'000, kRunningBaud = 1'456'312;
constexpr std::uint16_t kPurgeIn = 1, kPurgeOut = 2, kEightBits = 8;
constexpr std::uint16_t kDtrLow = 0x0100, kDtrHigh = 0x0101, kRtsLow = 0x0200;
constexpr std::uint16_t kSlowLatency = 16, kFastLatency = 1;  // [ms]
constexpr std::chrono::milliseconds kSoon = 100ms, kLate = 1000ms;

/// What the loader is asked, and answers; in front of the answer some have seen one more byte.
constexpr std::array<std::uint8_t, 3> kWho = {0x0a, 0x43, 0x0d};
constexpr std::array<std::uint8_t, 4> kLoader = {0x0a, 0x44, 0x2c, 0x0d};
constexpr std::uint8_t kBegin = 0x41;

class Boot {
 public:
  explicit Boot(SerialPort& port) : port_(port) {}

  bool runs();
  /// What went wrong; nothing: the firmware is in.
  std::optional<std::string> load(const Bytes& firmware);

 private:
  void request(Ftdi what, std::uint16_t value) { port_.control(static_cast<std::uint8_t>(what), value, 0); }
  void baud(unsigned baud) {
    const FtdiValue divisor = ftdiDivisor(baud);
    port_.control(static_cast<std::uint8_t>(Ftdi::baud), divisor.value, divisor.index);
  }
  void purge() {
    request(Ftdi::reset, kPurgeIn);
    request(Ftdi::reset, kPurgeOut);
  }
  bool isLoaderThere();
  bool isLoaderReady();

  SerialPort& port_;
};

bool Boot::runs() {
  baud(kRunningBaud);
  request(Ftdi::data, kEightBits);
  request(Ftdi::latency, kFastLatency);
  purge();
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    port_.send(encode(Order{}));
    if (decodeState(port_.receive(kPacketSize, kSoon))) return true;
  }
  return false;
}

bool Boot::isLoaderThere() {
  request(Ftdi::reset, 0);
  purge();
  request(Ftdi::latency, kSlowLatency);
  baud(kAskingBaud);
  request(Ftdi::data, kEightBits);
  request(Ftdi::flow, 0);
  request(Ftdi::modem, kRtsLow);
  request(Ftdi::modem, kDtrLow);
  request(Ftdi::modem, kDtrHigh);
  port_.send(kWho);
  Bytes answer = port_.receive(kLoader.size(), kLate);
  if (answer.size() == kLoader.size() && answer.back() != kLoader.back()) {
    const Bytes more = port_.receive(1, kSoon);
    answer.erase(answer.begin());
    answer.insert(answer.end(), more.begin(), more.end());
  }
  return std::equal(answer.begin(), answer.end(), kLoader.begin(), kLoader.end());
}

bool Boot::isLoaderReady() {
  request(Ftdi::modem, kDtrLow);
  baud(kLoadingBaud);
  request(Ftdi::modem, kDtrHigh);
  port_.send({&kBegin, 1});
  const Bytes answer = port_.receive(1, kLate);
  if (answer.empty()) return false;
  if (answer.front() == kBegin) return true;
  const Bytes more = port_.receive(1, kSoon);
  return !more.empty() && more.front() == kBegin;
}

std::optional<std::string> Boot::load(const Bytes& firmware) {
  if (!isLoaderThere()) return "its loader does not answer; check the Falcon's own power supply";
  if (!isLoaderReady()) return "its loader takes no firmware";
  for (std::size_t at = 0; at < firmware.size(); at += kFirmwareBlock) {
    const auto block = std::span(firmware).subspan(at, std::min(kFirmwareBlock, firmware.size() - at));
    port_.send(block);
    const Bytes echo = port_.receive(block.size(), kLate);
    if (!std::equal(echo.begin(), echo.end(), block.begin(), block.end()))
      return "byte " + std::to_string(at) + " and those after it of the firmware came back changed or not at all";
  }
  if (!runs()) return "it does not answer with the firmware that was given; is the file the Falcon's?";
  return std::nullopt;
}

}  // namespace

void boot(SerialPort& port, const std::function<std::vector<std::uint8_t>()>& firmware) {
  Boot boot(port);
  if (boot.runs()) return;
  const Bytes bytes = firmware();
  std::optional<std::string> trouble;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    trouble = boot.load(bytes);
    if (!trouble) return;
  }
  throw std::runtime_error("the Falcon cannot be set up: " + *trouble +
                           ". Unplug it from USB and power, plug it in again, and see docs/falcon.md");
}

}  // namespace haptiv::falcon
