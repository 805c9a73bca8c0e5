#include <algorithm>

#include "device/usb/protocol/StreamFrames.h"

namespace haptiv::usb {

namespace {

enum StateFlag : std::uint16_t { kDriving = 1u << 0, kArmed = 1u << 1 };
constexpr std::uint16_t kStateFlags = kDriving | kArmed;
constexpr std::uint16_t kKnownInputs = kInputDeadMan | kInputEmergencyStops | kInputReset;
constexpr int kPackedFlagShift = 6;           // above the six inputs, in the same byte
constexpr std::uint32_t kWatchdogUnit = 100;  // [us] in the packed form
constexpr std::uint32_t kWatchdogMost = 0xff;

std::uint16_t flagsOf(const BoardReport& report) noexcept {
  return static_cast<std::uint16_t>((report.driving ? kDriving : 0) | (report.armed ? kArmed : 0));
}

/// The number nearest to `before` whose lower `bits` bits are `low`.
std::int64_t nearest(std::uint64_t low, std::int64_t before, int bits) noexcept {
  const std::uint64_t ahead = (low - static_cast<std::uint64_t>(before)) << (64 - bits);
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(before) +
                                   static_cast<std::uint64_t>(static_cast<std::int64_t>(ahead) >> (64 - bits)));
}

void writeFull(WireWriter& out, const StateFrame& state) noexcept {
  const BoardReport& report = state.report;
  out.integer(state.sequence, 4);
  out.integer(report.time, 8);
  for (const std::int32_t count : report.reading.encoderCounts) out.integer(count, 4);
  for (const std::int16_t count : report.reading.sensorCounts) out.integer(count, 2);
  out.integer(report.reading.inputs, 2);
  out.integer(flagsOf(report), 2);
  out.integer(report.reading.trips, 4);
  out.integer(report.lastSequence, 4);
  out.integer(report.watchdogLeft, 4);
  const BoardCounters& counters = report.counters;
  for (const std::uint32_t count : {counters.damaged, counters.outOfOrder, counters.notFinite, counters.clamped})
    out.integer(count, 4);
}

void writePacked(WireWriter& out, const StateFrame& state) noexcept {
  const BoardReport& report = state.report;
  out.integer(state.sequence, 2);
  out.integer(report.time, 4);
  for (const std::int32_t count : report.reading.encoderCounts) out.integer(count, 3);
  for (const std::int16_t count : report.reading.sensorCounts) out.integer(count, 2);
  out.integer((report.reading.inputs & kKnownInputs) | flagsOf(report) << kPackedFlagShift, 1);
  out.integer(report.reading.trips, 4);
  out.integer(report.lastSequence, 2);
  out.integer(std::min(report.watchdogLeft / kWatchdogUnit, kWatchdogMost), 1);
}

bool setFlags(BoardReport& report, std::uint16_t inputs, std::uint16_t flags) noexcept {
  if ((flags & ~kStateFlags) != 0 || (inputs & ~kKnownInputs) != 0) return false;
  report.reading.inputs = inputs;
  report.driving = (flags & kDriving) != 0;
  report.armed = (flags & kArmed) != 0;
  return true;
}

bool readFull(WireReader& in, StateFrame& state) noexcept {
  BoardReport& report = state.report;
  state.sequence = in.unsignedInteger<std::uint32_t>();
  report.time = in.signedInteger<std::int64_t>();
  for (std::int32_t& count : report.reading.encoderCounts) count = in.signedInteger<std::int32_t>();
  for (std::int16_t& count : report.reading.sensorCounts) count = in.signedInteger<std::int16_t>();
  const auto inputs = in.unsignedInteger<std::uint16_t>();
  const auto flags = in.unsignedInteger<std::uint16_t>();
  report.reading.trips = in.unsignedInteger<std::uint32_t>();
  report.lastSequence = in.unsignedInteger<std::uint32_t>();
  report.watchdogLeft = in.unsignedInteger<std::uint32_t>();
  BoardCounters& counters = report.counters;
  for (std::uint32_t* count : {&counters.damaged, &counters.outOfOrder, &counters.notFinite, &counters.clamped})
    *count = in.unsignedInteger<std::uint32_t>();
  return setFlags(report, inputs, flags);
}

bool readPacked(WireReader& in, const StateFrame& before, StateFrame& state) noexcept {
  BoardReport& report = state.report;
  state.sequence = static_cast<std::uint32_t>(nearest(in.unsignedInteger<std::uint16_t>(), before.sequence, 16));
  report.time = nearest(in.unsignedInteger<std::uint32_t>(), before.report.time, 32);
  for (int i = 0; i < kJointCount; ++i)
    report.reading.encoderCounts[i] = static_cast<std::int32_t>(
        nearest(in.unsignedInteger<std::uint32_t>(3), before.report.reading.encoderCounts[i], 24));
  for (std::int16_t& count : report.reading.sensorCounts) count = in.signedInteger<std::int16_t>();
  const auto bits = in.unsignedInteger<std::uint8_t>();
  report.reading.trips = in.unsignedInteger<std::uint32_t>();
  report.lastSequence =
      static_cast<std::uint32_t>(nearest(in.unsignedInteger<std::uint16_t>(), before.report.lastSequence, 16));
  report.watchdogLeft = kWatchdogUnit * in.unsignedInteger<std::uint8_t>();
  return setFlags(report, bits & kKnownInputs, static_cast<std::uint16_t>(bits >> kPackedFlagShift));
}

}  // namespace

std::span<const std::uint8_t> encodeState(const StateFrame& state, FrameForm form,
                                          std::span<std::uint8_t, kLargestFrame> out) noexcept {
  WireWriter writer(out);
  writeHead(writer, form == FrameForm::full ? FrameType::state : FrameType::packedState);
  form == FrameForm::full ? writeFull(writer, state) : writePacked(writer, state);
  writer.crc();
  return out.first(writer.size());
}

FrameFault decodeState(std::span<const std::uint8_t> bytes, FrameForm form, StateFrame& state) noexcept {
  const bool full = form == FrameForm::full;
  const FrameFault fault = checkFrame(bytes, full ? FrameType::state : FrameType::packedState, stateSize(form));
  if (fault != FrameFault::none) return fault;
  WireReader in(bytes);
  in.skip(kHeadSize);
  StateFrame decoded;
  if (!(full ? readFull(in, decoded) : readPacked(in, state, decoded))) return FrameFault::content;
  state = decoded;
  return FrameFault::none;
}

}  // namespace haptiv::usb
