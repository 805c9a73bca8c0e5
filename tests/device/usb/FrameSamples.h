#pragma once

#include <vector>

#include "device/usb/protocol/ControlFrames.h"
#include "device/usb/protocol/StreamFrames.h"
#include "tests/support/Random.h"

namespace haptiv::usb {

using Packet = std::vector<std::uint8_t>;

inline Packet packet(std::span<const std::uint8_t> bytes) {
  return {bytes.begin(), bytes.end()};
}

inline Packet bytesOf(const StateFrame& state, FrameForm form) {
  std::array<std::uint8_t, kLargestFrame> out{};
  return packet(encodeState(state, form, out));
}
inline Packet bytesOf(const BoardCommand& command, FrameForm form) {
  std::array<std::uint8_t, kLargestFrame> out{};
  return packet(encodeCommand(command, form, out));
}
template <typename Frame>
Packet bytesOf(const Frame& frame) {
  ControlBytes out{};
  return packet(encode(frame, out));
}

/// Frames of any content that can be.
class FrameSamples {
 public:
  explicit FrameSamples(std::uint64_t seed) : random_(seed) {}

  std::int64_t integer(double low, double high) { return static_cast<std::int64_t>(random_.between(low, high)); }

  StateFrame state() {
    StateFrame s;
    BoardReport& r = s.report;
    s.sequence = word();
    r.time = integer(-1e15, 1e15);
    for (auto& count : r.reading.encoderCounts) count = static_cast<std::int32_t>(word());
    for (auto& count : r.reading.sensorCounts) count = static_cast<std::int16_t>(word());
    r.reading.inputs = word() & 0x3f;
    r.reading.trips = word();
    r.driving = (word() & 1) != 0;
    r.armed = (word() & 1) != 0;
    r.lastSequence = word();
    r.watchdogLeft = word() % 25'600 / 100 * 100;
    r.counters = {0, 0, word(), word(), word(), word()};
    return s;
  }
  BoardCommand command() {
    BoardCommand c;
    c.sequence = word();
    c.heartbeat = word();
    c.drive.mode = (word() & 1) != 0 ? DriveMode::torque : DriveMode::rate;
    (c.drive.mode == DriveMode::torque ? c.drive.jointTorques : c.drive.jointRates) =
        random_.vector<JointVector>(-80, 80);
    c.drive.enabled = (word() & 1) != 0;
    c.reset = (word() & 1) != 0;
    c.trip = (word() & 1) != 0;
    return c;
  }
  std::uint32_t word() { return static_cast<std::uint32_t>(random_.between(0, 4294967296.)); }

 private:
  test::Random random_;
};

}  // namespace haptiv::usb
