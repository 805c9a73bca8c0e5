/// The frames that stream between host and board, against the tables of docs/usb-protocol.md.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/device/usb/FrameSamples.h"

namespace haptiv::usb {
namespace {

constexpr FrameForm kForms[] = {FrameForm::full, FrameForm::packed};

std::uint64_t little(const Packet& bytes, std::size_t at, int size) {
  std::uint64_t value = 0;
  for (int i = 0; i < size; ++i) value |= static_cast<std::uint64_t>(bytes[at + i]) << 8 * i;
  return value;
}

void expectSame(const BoardReport& a, const BoardReport& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.reading.encoderCounts, b.reading.encoderCounts);
  EXPECT_EQ(a.reading.sensorCounts, b.reading.sensorCounts);
  EXPECT_EQ(a.reading.inputs, b.reading.inputs);
  EXPECT_EQ(a.reading.trips, b.reading.trips);
  EXPECT_EQ(a.lastSequence, b.lastSequence);
  EXPECT_EQ(a.watchdogLeft, b.watchdogLeft);
  EXPECT_EQ(a.driving, b.driving);
  EXPECT_EQ(a.armed, b.armed);
}

TEST(StreamFrames, HoldStatesAsTheyAre) {
  FrameSamples samples(1);
  for (int i = 0; i < 1000; ++i) {
    const StateFrame state = samples.state();
    StateFrame decoded;
    ASSERT_EQ(decodeState(bytesOf(state, FrameForm::full), FrameForm::full, decoded), FrameFault::none);
    EXPECT_EQ(decoded.sequence, state.sequence);
    expectSame(decoded.report, state.report);
    EXPECT_EQ(decoded.report.counters.damaged, state.report.counters.damaged);
    EXPECT_EQ(decoded.report.counters.clamped, state.report.counters.clamped);
  }
}

TEST(StreamFrames, OfThePackedFormAreCompletedByTheFrameBefore) {
  FrameSamples samples(2);
  for (int i = 0; i < 1000; ++i) {
    StateFrame state = samples.state();
    StateFrame before = state;  // what the host knows: up to 30 s, 8 million counts and 30,000 frames older, or newer
    before.sequence -= static_cast<std::uint32_t>(samples.integer(-30'000, 30'000));
    before.report.lastSequence -= static_cast<std::uint32_t>(samples.integer(-30'000, 30'000));
    before.report.time -= samples.integer(-3e7, 3e7);
    for (auto& count : before.report.reading.encoderCounts)
      count = static_cast<std::int32_t>(static_cast<std::uint32_t>(count) -
                                        static_cast<std::uint32_t>(samples.integer(-8e6, 8e6)));
    StateFrame decoded = before;
    ASSERT_EQ(decodeState(bytesOf(state, FrameForm::packed), FrameForm::packed, decoded), FrameFault::none);
    EXPECT_EQ(decoded.sequence, state.sequence);
    expectSame(decoded.report, state.report);
  }
}

TEST(StreamFrames, HoldCommandsToTheUnitOfTheWire) {
  FrameSamples samples(3);
  for (const FrameForm form : kForms) {
    for (int i = 0; i < 1000; ++i) {
      const BoardCommand command = samples.command();
      BoardCommand decoded = command;
      decoded.sequence += 77;  // the command before
      ASSERT_EQ(decodeCommand(bytesOf(command, form), form, decoded), FrameFault::none);
      EXPECT_EQ(decoded.sequence, command.sequence);
      EXPECT_EQ(decoded.heartbeat, command.heartbeat);
      EXPECT_EQ(decoded.drive.mode, command.drive.mode);
      EXPECT_EQ(decoded.drive.enabled, command.drive.enabled);
      EXPECT_EQ(decoded.reset, command.reset);
      EXPECT_EQ(decoded.trip, command.trip);
      const double unit = form == FrameForm::full ? 1e-6 : 1e-4;
      EXPECT_TRUE(decoded.drive.jointRates.isApprox(command.drive.jointRates, 0) ||
                  (decoded.drive.jointRates - command.drive.jointRates).cwiseAbs().maxCoeff() <= 0.5001 * unit);
      EXPECT_LE((decoded.drive.jointTorques - command.drive.jointTorques).cwiseAbs().maxCoeff(), 0.5001 * unit);
    }
  }
}

TEST(StreamFrames, KeepWhatIsNoNumberAndCutWhatIsTooLarge) {
  for (const FrameForm form : kForms) {
    BoardCommand command;
    command.drive.jointRates[0] = std::numeric_limits<double>::quiet_NaN();
    command.drive.jointRates[1] = -std::numeric_limits<double>::infinity();
    command.drive.jointRates[2] = 1e300;
    command.drive.jointRates[3] = -1e300;
    BoardCommand decoded;
    ASSERT_EQ(decodeCommand(bytesOf(command, form), form, decoded), FrameFault::none);
    EXPECT_TRUE(std::isnan(decoded.drive.jointRates[0]));
    EXPECT_TRUE(std::isnan(decoded.drive.jointRates[1]));
    EXPECT_GT(decoded.drive.jointRates[2], 80);
    EXPECT_EQ(decoded.drive.jointRates[3], -decoded.drive.jointRates[2]);
  }
}

TEST(StreamFrames, OfStatesStandInTheBytesAsTheTableSays) {
  StateFrame state;
  state.sequence = 0x01020304;
  state.report.time = 0x1122334455;
  state.report.reading.encoderCounts[9] = -2;
  state.report.reading.sensorCounts[5] = -3;
  state.report.reading.inputs = kInputDeadMan | kInputEmergencyStop2;
  state.report.reading.trips = kTripEmergencyStop;
  state.report.armed = true;
  state.report.lastSequence = 0xa0b0c0d0;
  state.report.watchdogLeft = 7'300;
  state.report.counters.clamped = 5;
  const Packet full = bytesOf(state, FrameForm::full);
  ASSERT_EQ(full.size(), 104u);
  EXPECT_EQ(packet(std::span(full).first(8)), (Packet{'H', 'V', 1, 0x01, 4, 3, 2, 1}));
  EXPECT_EQ(little(full, 8, 8), 0x1122334455u);
  EXPECT_EQ(little(full, 52, 4), 0xfffffffeu);
  EXPECT_EQ(little(full, 66, 2), 0xfffdu);
  EXPECT_EQ(little(full, 68, 2), 5u);
  EXPECT_EQ(little(full, 70, 2), 2u);
  EXPECT_EQ(little(full, 72, 4), 4u);
  EXPECT_EQ(little(full, 76, 4), 0xa0b0c0d0u);
  EXPECT_EQ(little(full, 80, 4), 7'300u);
  EXPECT_EQ(little(full, 96, 4), 5u);
  const Packet packed = bytesOf(state, FrameForm::packed);
  ASSERT_EQ(packed.size(), 64u);
  EXPECT_EQ(packet(std::span(packed).first(6)), (Packet{'H', 'V', 1, 0x11, 4, 3}));
  EXPECT_EQ(little(packed, 6, 4), 0x22334455u);
  EXPECT_EQ(little(packed, 37, 3), 0xfffffeu);
  EXPECT_EQ(packed[52], 5 | 2 << 6);
  EXPECT_EQ(little(packed, 53, 4), 4u);
  EXPECT_EQ(little(packed, 57, 2), 0xc0d0u);
  EXPECT_EQ(packed[59], 73);
}

TEST(StreamFrames, OfCommandsStandInTheBytesAsTheTableSays) {
  BoardCommand command;
  command.heartbeat = 0x0a0b0c0d;
  command.drive.enabled = true;
  command.drive.jointRates[0] = -1;
  const Packet asked = bytesOf(command, FrameForm::full);
  ASSERT_EQ(asked.size(), 60u);
  EXPECT_EQ(little(asked, 8, 4), 0x0a0b0c0du);
  EXPECT_EQ(little(asked, 12, 4), 0x0100u);
  EXPECT_EQ(static_cast<std::int32_t>(little(asked, 16, 4)), -1'000'000);
  const Packet askedPacked = bytesOf(command, FrameForm::packed);
  ASSERT_EQ(askedPacked.size(), 44u);
  EXPECT_EQ(little(askedPacked, 10, 3), 0x1000000u - 100'000u);
}

TEST(StreamFrames, EndInTheChecksumThatEveryoneKnows) {
  const Packet text = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(crc32(text), 0xcbf43926u);  // the check value of CRC-32 in every catalogue
}

TEST(StreamFrames, WithAnyTwoBitsTurnedAreRefused) {
  for (const FrameForm form : kForms) {
    Packet bytes = bytesOf(FrameSamples(4).command(), form);
    const auto turn = [&](std::size_t bit) { bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8); };
    for (std::size_t a = 0; a < 8 * bytes.size(); ++a) {
      for (std::size_t b = a; b < 8 * bytes.size(); ++b) {
        turn(a);
        if (a != b) turn(b);
        BoardCommand decoded;
        ASSERT_NE(decodeCommand(bytes, form, decoded), FrameFault::none) << "bits " << a << ", " << b;
        ASSERT_EQ(decoded.sequence, 0u);
        turn(a);
        if (a != b) turn(b);
      }
    }
  }
}

TEST(StreamFrames, OfAnotherLengthVersionTypeOrFormAreRefusedWithTheReason) {
  const StateFrame sample = FrameSamples(5).state();
  for (const FrameForm form : kForms) {
    const FrameForm other = form == FrameForm::full ? FrameForm::packed : FrameForm::full;
    const Packet good = bytesOf(sample, form);
    const auto faultOf = [&](Packet bytes, FrameForm as) {
      StateFrame decoded;
      return decodeState(bytes, as, decoded);
    };
    EXPECT_EQ(faultOf({}, form), FrameFault::length);
    for (std::size_t size = 0; size < good.size(); ++size)
      EXPECT_EQ(faultOf(packet(std::span(good).first(size)), form), FrameFault::length);
    Packet longer = good;
    longer.resize(128);
    EXPECT_EQ(faultOf(longer, form), FrameFault::length);
    Packet newer = good;
    newer[2] = kProtocolVersion + 1;
    EXPECT_EQ(faultOf(newer, form), FrameFault::version);
    Packet stranger = good;
    stranger[0] = 'X';
    EXPECT_EQ(faultOf(stranger, form), FrameFault::magic);
    EXPECT_EQ(faultOf(good, other), FrameFault::type);
    BoardCommand command;
    EXPECT_EQ(decodeCommand(good, form, command), FrameFault::type);
  }
}

TEST(StreamFrames, OfAContentThatCannotBeAreRefusedThoughTheirChecksumIsRight) {
  const auto withByte = [](Packet bytes, std::size_t at, std::uint8_t value) {
    bytes[at] = value;
    const std::uint32_t crc = crc32(std::span(bytes).first(bytes.size() - 4));
    for (int i = 0; i < 4; ++i) bytes[bytes.size() - 4 + i] = static_cast<std::uint8_t>(crc >> 8 * i);
    return bytes;
  };
  const Packet command = bytesOf(BoardCommand{}, FrameForm::full);
  BoardCommand decoded;
  ASSERT_EQ(decodeCommand(withByte(command, 13, 0x02), FrameForm::full, decoded), FrameFault::none);
  EXPECT_EQ(decodeCommand(withByte(command, 12, 2), FrameForm::full, decoded), FrameFault::content) << "a third mode";
  EXPECT_EQ(decodeCommand(withByte(command, 13, 0x03), FrameForm::full, decoded), FrameFault::content)
      << "drive and brake";
  EXPECT_EQ(decodeCommand(withByte(command, 13, 0x00), FrameForm::full, decoded), FrameFault::content) << "neither";
  EXPECT_EQ(decodeCommand(withByte(command, 13, 0x12), FrameForm::full, decoded), FrameFault::content) << "a new flag";
  const Packet state = bytesOf(StateFrame{}, FrameForm::full);
  StateFrame known;
  EXPECT_EQ(decodeState(withByte(state, 68, 0x40), FrameForm::full, known), FrameFault::content) << "a new input";
  EXPECT_EQ(decodeState(withByte(state, 70, 0x04), FrameForm::full, known), FrameFault::content) << "a new flag";
}

}  // namespace
}  // namespace haptiv::usb
