#pragma once

#include "device/realtime/TripleBuffer.h"
#include "device/usb/host/LinkCounters.h"
#include "device/usb/protocol/StreamFrames.h"

namespace haptiv::usb {

/// Takes state packets as they come and keeps the newest whole one for the servo. A damaged packet, and one that is
/// late or repeated, is dropped and counted; what is missing between two is counted.
class StateIntake {
 public:
  explicit StateIntake(LinkCounters& counters) : counters_(counters) {}

  /// A device has been opened: its first frame follows none. Thread: the link's, or before it runs.
  void begin(FrameForm form) noexcept;
  /// Whether it is the newest now. Thread: the link's.
  bool take(std::span<const std::uint8_t> packet) noexcept;
  /// Whether a state has come since `begin`, and the newest one. Thread: the link's.
  bool any() const noexcept { return any_; }
  const StateFrame& last() const noexcept { return known_; }

  /// The newest state, if it is new since the last call. Thread: the servo.  Realtime-safe: yes.
  bool newest(StateFrame& state) noexcept;

 private:
  LinkCounters& counters_;
  FrameForm form_ = FrameForm::full;
  StateFrame known_;
  bool any_ = false;
  TripleBuffer<StateFrame> states_;
};

}  // namespace haptiv::usb
