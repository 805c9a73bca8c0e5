/// The firmware's side of the wire, and the control requests.
#include <gtest/gtest.h>

#include "device/usb/peripheral/BoardPort.h"
#include "tests/device/board/BoardBench.h"
#include "tests/device/usb/FrameSamples.h"

namespace haptiv::usb {
namespace {

struct Port : testing::TestWithParam<FrameForm>, test::BoardBench {
  void sendBytes() {
    ++command.sequence;
    ++command.heartbeat;
    port.packetOut(bytesOf(command, GetParam()));
  }
  StateFrame receive() {
    std::array<std::uint8_t, kLargestFrame> out{};
    EXPECT_EQ(decodeState(port.packetIn(out), GetParam(), known), FrameFault::none);
    return known;
  }
  Packet ask(ControlRequest request) {
    ControlBytes out{};
    return packet(port.controlIn(static_cast<std::uint8_t>(request), out));
  }

  BoardPort port{board, GetParam(), {0x0102, 10, "vishard10"}};
  StateFrame known;
};

TEST_P(Port, DrivesTheArmByBytesAlone) {
  hostLives = false;
  command.drive.enabled = true;
  command.drive.jointRates.setConstant(0.25);
  sendBytes();
  tick();
  press(kInputDeadMan);
  tick();
  EXPECT_EQ(board.demand().setPoints, JointVector(JointVector::Constant(0.25)));
  const StateFrame state = receive();
  EXPECT_TRUE(state.report.driving);
  EXPECT_EQ(state.report.lastSequence, command.sequence);
  EXPECT_EQ(state.report.reading.inputs, kInputDeadMan);
  EXPECT_EQ(state.sequence, 1u);
  EXPECT_EQ(receive().sequence, 2u);
}

TEST_P(Port, CountsDamagedPacketsWhichDoNotFeedTheWatchdog) {
  hostLives = false;
  command.drive.enabled = true;
  sendBytes();
  tick();
  press(kInputDeadMan);
  tick();
  ASSERT_TRUE(drives());
  for (int i = 0; i < 11; ++i) {
    ++command.sequence;
    ++command.heartbeat;
    Packet bytes = bytesOf(command, GetParam());
    bytes[17] ^= 0x10;
    port.packetOut(bytes);
    tick();
  }
  EXPECT_FALSE(drives());
  EXPECT_EQ(trips(), kTripWatchdog);
  EXPECT_EQ(board.report().counters.damaged, 11u);
}

TEST_P(Port, TellsWhichBoardItIsAndWhatItCanDo) {
  Identity identity;
  ASSERT_EQ(decode(ask(ControlRequest::identity), identity), FrameFault::none);
  EXPECT_EQ(identity, (Identity{0x0102, 10, "vishard10"}));
  Capabilities capabilities;
  ASSERT_EQ(decode(ask(ControlRequest::capabilities), capabilities), FrameFault::none);
  EXPECT_TRUE(capabilities.rateLimit.isApprox(description.drives.rateLimit, 1e-9));
  EXPECT_TRUE(capabilities.torqueLimit.isApprox(description.drives.torqueLimit, 1e-9));
  CircuitThresholds thresholds;
  ASSERT_EQ(decode(ask(ControlRequest::getThresholds), thresholds), FrameFault::none);
  EXPECT_EQ(thresholds, board.thresholds());
}

TEST_P(Port, SetsThresholdsAndZeroOrStalls) {
  const auto tell = [&](ControlRequest request, const Packet& bytes) {
    return port.controlOut(static_cast<std::uint8_t>(request), bytes);
  };
  CircuitThresholds wanted = board.thresholds();
  wanted.watchdogTime = 4'000;
  EXPECT_TRUE(tell(ControlRequest::setThresholds, bytesOf(wanted)));
  EXPECT_EQ(board.thresholds(), wanted);
  wanted.watchdogTime = 400'000;
  EXPECT_FALSE(tell(ControlRequest::setThresholds, bytesOf(wanted)));
  HomeCounts counts{};
  counts[1] = 99;
  Packet damaged = bytesOf(counts);
  damaged[9] ^= 1;
  EXPECT_FALSE(tell(ControlRequest::home, damaged));
  EXPECT_FALSE(tell(ControlRequest::home, {}));
  EXPECT_TRUE(tell(ControlRequest::home, bytesOf(counts)));
  EXPECT_EQ(board.report().reading.encoderCounts, counts);
  EXPECT_FALSE(tell(ControlRequest::identity, bytesOf(counts)));
  EXPECT_TRUE(ask(ControlRequest::home).empty());
  EXPECT_FALSE(port.controlOut(0xff, bytesOf(counts)));
}

INSTANTIATE_TEST_SUITE_P(Forms, Port, testing::Values(FrameForm::full, FrameForm::packed),
                         [](const auto& form) { return form.param == FrameForm::full ? "Full" : "Packed"; });

TEST(ControlFrames, OfAHostileNameOrJointCountAreRefused) {
  Identity kept{1, 2, "kept"};
  const Identity before = kept;
  EXPECT_EQ(decode(bytesOf(Identity{1, 11, "too many joints"}), kept), FrameFault::content);
  EXPECT_EQ(decode(bytesOf(Identity{1, 0, "no joint"}), kept), FrameFault::content);
  EXPECT_EQ(decode(bytesOf(Identity{1, 10, "\x1b[2J"}), kept), FrameFault::content);
  EXPECT_EQ(kept, before);
  EXPECT_EQ(decode(bytesOf(Identity{1, 10, std::string(40, 'n')}), kept), FrameFault::none);
  EXPECT_EQ(kept.name, std::string(kNameSize, 'n'));
}

}  // namespace
}  // namespace haptiv::usb
