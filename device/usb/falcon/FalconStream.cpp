#include "device/usb/falcon/FalconStream.h"

#include <algorithm>

namespace haptiv::falcon {

std::optional<State> Stream::take(std::span<const std::uint8_t> transfer) noexcept {
  std::optional<State> newest;
  while (!transfer.empty()) {
    const auto packet = transfer.first(std::min(transfer.size(), kUsbPacket));
    for (std::size_t i = kStatus; i < packet.size(); ++i) take(packet[i], newest);
    transfer = transfer.subspan(packet.size());
  }
  return newest;
}

void Stream::take(std::uint8_t byte, std::optional<State>& newest) noexcept {
  if (count_ == 0 && byte != '<') return;
  held_[count_++] = byte;
  if (count_ < kPacketSize) return;
  if (const auto state = decodeState(held_)) {
    newest = state;
    ++states_;
    count_ = 0;
  } else {
    ++damaged_;
    resynchronise();
  }
}

void Stream::resynchronise() noexcept {
  const auto next = std::find(held_.begin() + 1, held_.end(), '<');
  count_ = static_cast<std::size_t>(std::copy(next, held_.end(), held_.begin()) - held_.begin());
}

}  // namespace haptiv::falcon
