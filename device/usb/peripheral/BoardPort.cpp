#include "device/usb/peripheral/BoardPort.h"

namespace haptiv::usb {

std::span<const std::uint8_t> BoardPort::packetIn(std::span<std::uint8_t, kLargestFrame> out) noexcept {
  return encodeState({++sequence_, board_.report()}, form_, out);
}

void BoardPort::packetOut(std::span<const std::uint8_t> bytes) noexcept {
  BoardCommand command = last_;
  if (decodeCommand(bytes, form_, command) != FrameFault::none) {
    board_.countDamaged();
    return;
  }
  if (board_.accept(command) == Acceptance::accepted) last_ = command;
}

std::span<const std::uint8_t> BoardPort::controlIn(std::uint8_t request, ControlBytes& out) const {
  switch (static_cast<ControlRequest>(request)) {
    case ControlRequest::identity:
      return encode(Identity{identity_.firmware, identity_.joints, identity_.name, board_.homed()}, out);
    case ControlRequest::capabilities:
      return encode(Capabilities{board_.settings().rateLimit, board_.settings().torqueLimit}, out);
    case ControlRequest::getThresholds:
      return encode(board_.thresholds(), out);
    default:
      return {};
  }
}

bool BoardPort::controlOut(std::uint8_t request, std::span<const std::uint8_t> bytes) {
  CircuitThresholds thresholds = board_.thresholds();
  HomeCounts counts{};
  switch (static_cast<ControlRequest>(request)) {
    case ControlRequest::setThresholds:
      return decode(bytes, thresholds) == FrameFault::none && board_.configure(thresholds);
    case ControlRequest::home:
      return decode(bytes, counts) == FrameFault::none && board_.home(counts);
    default:
      return false;
  }
}

}  // namespace haptiv::usb
