#include "device/usb/host/StateIntake.h"

namespace haptiv::usb {

void StateIntake::begin(FrameForm form) noexcept {
  form_ = form;
  known_ = {};
  any_ = false;
}

bool StateIntake::take(std::span<const std::uint8_t> packet) noexcept {
  StateFrame state = known_;
  if (decodeState(packet, form_, state) != FrameFault::none) {
    ++counters_.damaged;
    return false;
  }
  const auto ahead = static_cast<std::int32_t>(state.sequence - known_.sequence);
  if (any_ && ahead <= 0) {
    ++counters_.outOfOrder;
    return false;
  }
  if (any_) counters_.missing += static_cast<std::uint64_t>(ahead - 1);
  any_ = true;
  known_ = state;
  states_.write(state);
  ++counters_.states;
  return true;
}

bool StateIntake::newest(StateFrame& state) noexcept {
  if (!states_.update()) return false;
  state = states_.read();
  return true;
}

}  // namespace haptiv::usb
