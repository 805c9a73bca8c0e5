#include "device/usb/falcon/FalconClient.h"

#include <algorithm>
#include <chrono>

#include "device/usb/falcon/FalconBoot.h"
#include "device/usb/falcon/FalconPort.h"
#include "device/usb/libusb/UsbFailure.h"

namespace haptiv::falcon {
namespace {

std::int64_t now() noexcept {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

}  // namespace

Client::Client(const DeviceDescription& description, Firmware firmware)
    : logic_(description),
      firmware_(std::move(firmware)),
      watchdogTime_(static_cast<std::int64_t>(1e9 * std::min(description.safety.watchdogTime, 1.))) {}

usb::StreamEndpoints Client::prepare(usb::UsbHandle& handle) {
  Port port(handle);
  try {
    boot(port, firmware_);
  } catch (const usb::UsbFailure&) {
    throw;
  } catch (const std::exception& error) {  // the link knows failures of USB alone
    throw usb::UsbFailure(usb::UsbTrouble::other, error.what());
  }
  stream_.restart();
  last_.state = {};
  last_.homing = Homing::searching;
  answered_ = true;
  sentStill_ = still_ = true;
  silent_ = kPatience;
  there_ = true;
  return {usb::TransferKind::bulk, kInEndpoint, Stream::kUsbPacket, kOutEndpoint, Stream::kUsbPacket};
}

void Client::received(std::span<const std::uint8_t> packet) noexcept {
  const auto state = stream_.take(packet);
  damaged_ = stream_.damaged();
  if (!state) {
    ++silent_;
    return;
  }
  ++states_;
  last_ = {*state, next(last_.homing, state->homed), states_};
  answered_ = true;
  if (sentStill_) still_ = true;
  seen_.write(last_);
}

std::size_t Client::send(std::span<std::uint8_t> packet) noexcept {
  const bool isDue = silent_ >= kPatience;
  if (!answered_ && !isDue) return 0;
  if (!given_.update()) {
    if (!isDue) return 0;
    ++unasked_;
  }
  const Given& given = given_.read();
  const bool isFresh = now() - given.writtenAt <= watchdogTime_;
  const Order order = logic_.order(isFresh ? given.command : DeviceCommand{}, last_.state, last_.homing);
  const Packet bytes = encode(order);
  std::copy(bytes.begin(), bytes.end(), packet.begin());
  answered_ = false;
  silent_ = 0;
  ++sent_;
  sentStill_ = order.motors == Order{}.motors;
  if (!sentStill_) still_ = false;
  return bytes.size();
}

void Client::lost() noexcept {
  there_ = false;
  ++losses_;
}

bool Client::newest(Seen& seen) noexcept {
  if (!seen_.update()) return false;
  seen = seen_.read();
  return true;
}

void Client::write(const DeviceCommand& command) noexcept {
  given_.write({command, now()});
}

}  // namespace haptiv::falcon
