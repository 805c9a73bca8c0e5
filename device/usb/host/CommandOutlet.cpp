#include "device/usb/host/CommandOutlet.h"

#include <algorithm>
#include <array>
#include <chrono>

namespace haptiv::usb {

namespace {

std::int64_t now() noexcept {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

}  // namespace

void CommandOutlet::write(const DeviceCommand& drive, bool reset, bool trip) noexcept {
  commands_.write({{0, ++heartbeat_, drive, reset, trip}, now()});
}

void CommandOutlet::begin(FrameForm form) noexcept {
  form_ = form;
  numbered_ = false;
  brakes_ = true;
  braked_ = true;
  timed_ = {};
  commands_.update();
}

std::size_t CommandOutlet::packet(std::span<std::uint8_t> out, std::uint32_t echo) noexcept {
  if (!commands_.update()) return 0;
  if (!numbered_) sequence_ = brakedSince_ = echo;
  numbered_ = true;
  Outgoing outgoing = commands_.read();
  outgoing.command.sequence = ++sequence_;
  const bool brakes = !outgoing.command.drive.enabled;
  if (!brakes) braked_ = false;
  if (brakes && !brakes_) brakedSince_ = sequence_;
  brakes_ = brakes;
  if (sequence_ % kTimed == 0) timed_ = {sequence_, outgoing.writtenAt};
  ++counters_.sent;
  std::array<std::uint8_t, kLargestFrame> bytes{};
  const auto frame = encodeCommand(outgoing.command, form_, bytes);
  std::copy(frame.begin(), frame.end(), out.begin());
  return frame.size();
}

void CommandOutlet::skip() noexcept {
  if (commands_.update()) ++counters_.skipped;
}

void CommandOutlet::echoed(std::uint32_t sequence) noexcept {
  if (awaitsEcho() && sequence == timed_.sequence) latencies_.add(now() - timed_.writtenAt);
  if (static_cast<std::int32_t>(sequence - timed_.sequence) >= 0) timed_ = {};
  if (numbered_ && brakes_ && static_cast<std::int32_t>(sequence - brakedSince_) >= 0) braked_ = true;
}

}  // namespace haptiv::usb
