#include "app/board/usbip/Pipes.h"

#include <algorithm>

#include "device/usb/protocol/BoardProfile.h"

namespace haptiv::usbip {
namespace {

constexpr std::uint8_t kIn = 0x80;
constexpr int kMicroframesPerFrame = 8;

}  // namespace

void Pipes::reset() {
  in_.clear();
  out_.clear();
  phase_ = 0;
  board_.control().reset();
}

void Pipes::answerControl(const Submit& urb, Bytes& out) {
  const usb::SetupPacket setup = usb::decodeSetup(urb.setup);
  const auto answer = setup.isIn() == urb.in ? board_.control().answer(setup, urb.data) : std::nullopt;
  const UrbStatus status = answer ? UrbStatus::good : UrbStatus::stall;
  if (!urb.in) return writeOutDone(urb.sequence, status, answer ? urb.length : 0, out);
  const std::span<const std::uint8_t> data =
      answer ? std::span<const std::uint8_t>(*answer) : std::span<const std::uint8_t>();
  writeInDone(urb.sequence, status, data.first(std::min<std::size_t>(data.size(), urb.length)), out);
}

bool Pipes::submit(const Submit& urb, Bytes& out) {
  if (urb.endpoint == 0) {
    answerControl(urb, out);
    return true;
  }
  const auto address = static_cast<std::uint8_t>(urb.endpoint | (urb.in ? kIn : 0));
  if (address != usb::kStateEndpoint && address != usb::kCommandEndpoint) {
    urb.in ? writeInDone(urb.sequence, UrbStatus::noSuchEndpoint, {}, out)
           : writeOutDone(urb.sequence, UrbStatus::noSuchEndpoint, 0, out);
    return true;
  }
  if (pending() >= kMostPending) return false;
  (urb.in ? in_ : out_).push_back({urb.sequence, urb.length, urb.data});
  return true;
}

void Pipes::unlink(const Unlink& urb, Bytes& out) {
  const auto isVictim = [&](const Waiting& each) { return each.sequence == urb.victim; };
  const auto taken = std::erase_if(in_, isVictim) + std::erase_if(out_, isVictim);
  // One that is not there has been answered: that came first, and this says so.
  writeUnlinked(urb.sequence, taken > 0 ? UrbStatus::unlinked : UrbStatus::good, out);
}

void Pipes::sendState(Bytes& out) {
  const Waiting urb = std::move(in_.front());
  in_.pop_front();
  if (!board_.control().isOpen(usb::kStateEndpoint)) return writeInDone(urb.sequence, UrbStatus::stall, {}, out);
  std::array<std::uint8_t, usb::kLargestFrame> bytes{};
  const auto frame = board_.port().packetIn(bytes);
  // A host that has less room than a packet sees a babble.
  if (urb.length < frame.size()) return writeInDone(urb.sequence, UrbStatus::overflow, {}, out);
  writeInDone(urb.sequence, UrbStatus::good, frame, out);
}

void Pipes::takeCommand(Bytes& out) {
  const Waiting urb = std::move(out_.front());
  out_.pop_front();
  if (!board_.control().isOpen(usb::kCommandEndpoint)) return writeOutDone(urb.sequence, UrbStatus::stall, 0, out);
  std::span<const std::uint8_t> rest = urb.data;  // a longer transfer is several packets
  do {
    const auto packet = rest.first(std::min<std::size_t>(rest.size(), usb::kCommandPacket));
    board_.port().packetOut(packet);
    rest = rest.subspan(packet.size());
  } while (!rest.empty());
  writeOutDone(urb.sequence, UrbStatus::good, static_cast<std::uint32_t>(urb.data.size()), out);
}

void Pipes::microframe(Bytes& out) {
  const int every = board_.form() == usb::FrameForm::full ? 1 : kMicroframesPerFrame;
  if (++phase_ < every) return;
  phase_ = 0;
  if (!out_.empty()) takeCommand(out);
  if (!in_.empty()) sendState(out);
}

}  // namespace haptiv::usbip
