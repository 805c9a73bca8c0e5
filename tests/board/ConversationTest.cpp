/// USB/IP without a socket: what a host asks, byte for byte, and what comes back.
#include "app/board/usbip/Conversation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/board/UsbIpPeer.h"
#include "tests/device/usb/FrameSamples.h"

namespace haptiv::usbip {
namespace {

using test::UsbIpWords;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct Hosted : testing::Test {
  usb::VirtualBoard board{{loadDeviceDescription("vishard10")}, nullptr};
  Export exported{board};
  Conversation host{exported};

  Bytes tell(const Bytes& bytes) {
    host.receive(bytes);
    return take();
  }
  Bytes take() { return std::exchange(host.outgoing(), {}); }
  Bytes pass(int microframes) {
    for (int i = 0; i < microframes; ++i) {
      board.advance();
      host.microframe();
    }
    return take();
  }
  void import() {
    ASSERT_THAT(tell(UsbIpWords::import("1-1")), SizeIs(8 + 312));
    ASSERT_TRUE(host.isImporter());
    tell(UsbIpWords::configure(1));
  }
};

std::string textAt(const Bytes& bytes, std::size_t at) {
  return reinterpret_cast<const char*>(bytes.data()) + at;
}

TEST_F(Hosted, ListsTheBoardAndHangsUp) {
  const Bytes list = tell(UsbIpWords::list());
  ASSERT_THAT(list, SizeIs(12 + 312 + 4));
  EXPECT_EQ(UsbIpWords::word(list, 0), 0x01110005u);
  EXPECT_EQ(UsbIpWords::word(list, 4), 0u);
  EXPECT_EQ(UsbIpWords::word(list, 8), 1u);
  EXPECT_EQ(textAt(list, 12 + 256), "1-1");
  EXPECT_EQ(UsbIpWords::word(list, 12 + 288 + 8), 3u) << "high speed";
  EXPECT_EQ(UsbIpWords::word(list, 12 + 300), 0x12090001u) << "vendor and product";
  EXPECT_EQ(list[12 + 311], 1) << "interface";
  EXPECT_EQ(UsbIpWords::word(list, 12 + 312), 0xff480100u) << "its class";
  EXPECT_TRUE(host.isOver());
  EXPECT_THAT(host.reproach(), IsEmpty());
}

TEST_F(Hosted, GivesTheBoardToOneHostAtATime) {
  import();
  {
    Conversation second(exported);
    second.receive(UsbIpWords::import("1-1"));
    EXPECT_THAT(second.outgoing(), SizeIs(8));
    EXPECT_EQ(UsbIpWords::word(second.outgoing(), 4), 2u) << "busy";
    EXPECT_TRUE(second.isOver());
  }
  EXPECT_TRUE(exported.taken) << "the second one's end is not the first one's";
  Conversation other(exported);
  other.receive(UsbIpWords::import("3-2"));
  EXPECT_EQ(UsbIpWords::word(other.outgoing(), 4), 4u) << "no such device";
}

TEST_F(Hosted, IsFreeAgainWhenTheHostIsGone) {
  {
    Conversation first(exported);
    first.receive(UsbIpWords::import("1-1"));
    ASSERT_TRUE(first.isImporter());
    first.receive(UsbIpWords::urb(9, true, 1, 128));
  }
  EXPECT_EQ(exported.pipes.pending(), 0u);
  import();
}

TEST_F(Hosted, TellsItsDescriptors) {
  import();
  const Bytes answer = tell(UsbIpWords::descriptor(7, 1, 0, 18));
  ASSERT_THAT(answer, SizeIs(48 + 18));
  EXPECT_EQ(UsbIpWords::word(answer, 0), 3u);
  EXPECT_EQ(UsbIpWords::word(answer, 4), 7u);
  EXPECT_EQ(UsbIpWords::word(answer, 20), 0u);
  EXPECT_EQ(UsbIpWords::word(answer, 24), 18u);
  EXPECT_EQ(answer[48 + 8], 0x09);
  EXPECT_EQ(answer[48 + 9], 0x12);
  EXPECT_THAT(tell(UsbIpWords::descriptor(8, 2, 0, 9)), SizeIs(48 + 9)) << "no more than asked for";
  const Bytes stalled = tell(UsbIpWords::descriptor(9, 99, 0, 18));
  EXPECT_EQ(UsbIpWords::word(stalled, 20), static_cast<std::uint32_t>(-32));
  EXPECT_THAT(stalled, SizeIs(48));
}

TEST_F(Hosted, SendsOneStateAMicroframeToThoseWhoAsk) {
  import();
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_THAT(tell(UsbIpWords::urb(10 + i, true, 1, 128)), IsEmpty());
  const Bytes first = pass(1), rest = pass(5);
  ASSERT_THAT(first, SizeIs(48 + usb::kStateSize));
  EXPECT_EQ(UsbIpWords::word(first, 4), 10u);
  EXPECT_THAT(rest, SizeIs(2 * first.size()));
  usb::StateFrame state;
  EXPECT_EQ(usb::decodeState(std::span(first).subspan(48), usb::FrameForm::full, state), usb::FrameFault::none);
  EXPECT_EQ(state.report.time, 125);
  EXPECT_THAT(pass(3), IsEmpty());
}

TEST_F(Hosted, DrivesTheArmThroughThePipes) {
  import();
  BoardCommand command;
  command.drive.enabled = true;
  command.drive.jointRates[0] = 0.5;
  const JointVector before = board.angles();
  for (std::uint32_t i = 1; i <= 400; ++i) {
    command.sequence = command.heartbeat = i;
    const Bytes frame = usb::bytesOf(command, usb::FrameForm::full);
    tell(UsbIpWords::urb(100 + i, false, 1, static_cast<std::uint32_t>(frame.size()), {}, frame));
    const Bytes done = pass(8);
    ASSERT_THAT(done, SizeIs(48));
    ASSERT_EQ(UsbIpWords::word(done, 24), frame.size());
    board.press(i > 2 ? kInputDeadMan : 0);
  }
  EXPECT_TRUE(board.report().driving);
  EXPECT_NEAR(board.angles()[0] - before[0], 0.5 * 0.4, 0.02);
  pass(8 * 12);
  EXPECT_FALSE(board.report().driving) << "nobody feeds the watchdog";
  EXPECT_EQ(board.report().reading.trips, kTripWatchdog);
}

TEST_F(Hosted, UnlinksATransferThatWaits) {
  import();
  tell(UsbIpWords::urb(20, true, 1, 128));
  const Bytes unlinked = tell(UsbIpWords::unlink(21, 20));
  ASSERT_THAT(unlinked, SizeIs(48));
  EXPECT_EQ(UsbIpWords::word(unlinked, 0), 4u);
  EXPECT_EQ(UsbIpWords::word(unlinked, 4), 21u);
  EXPECT_EQ(UsbIpWords::word(unlinked, 20), static_cast<std::uint32_t>(-104));
  EXPECT_THAT(pass(2), IsEmpty());
  const Bytes late = tell(UsbIpWords::unlink(22, 20));
  EXPECT_EQ(UsbIpWords::word(late, 20), 0u) << "nothing waits";
}

TEST_F(Hosted, StallsEndpointsUntilItIsConfiguredAndWhileTheyAreHalted) {
  tell(UsbIpWords::import("1-1"));
  tell(UsbIpWords::urb(1, true, 1, 128));
  EXPECT_EQ(UsbIpWords::word(pass(1), 20), static_cast<std::uint32_t>(-32));
  tell(UsbIpWords::configure(2));
  tell(UsbIpWords::urb(3, false, 0, 0, {0x02, 3, 0, 0, 0x81, 0, 0, 0}));  // SET_FEATURE(halt)
  tell(UsbIpWords::urb(4, true, 1, 128));
  EXPECT_EQ(UsbIpWords::word(pass(1), 20), static_cast<std::uint32_t>(-32));
  tell(UsbIpWords::urb(5, false, 0, 0, {0x02, 1, 0, 0, 0x81, 0, 0, 0}));  // CLEAR_FEATURE(halt)
  tell(UsbIpWords::urb(6, true, 1, 128));
  EXPECT_EQ(UsbIpWords::word(pass(1), 20), 0u);
}

TEST_F(Hosted, TellsAHostWithTooLittleRoomThatItOverflows) {
  import();
  tell(UsbIpWords::urb(5, true, 1, 64));
  const Bytes answer = pass(1);
  EXPECT_EQ(UsbIpWords::word(answer, 20), static_cast<std::uint32_t>(-75));
  EXPECT_THAT(answer, SizeIs(48));
  EXPECT_EQ(UsbIpWords::word(tell(UsbIpWords::urb(6, true, 5, 64)), 20), static_cast<std::uint32_t>(-2));
}

TEST_F(Hosted, HangsUpOnWhatIsNoUsbIp) {
  for (const Bytes& bytes : {Bytes{'G', 'E', 'T', ' ', '/', ' ', 'H', 'T'}, Bytes{1, 0x11, 0x80, 0x7f, 0, 0, 0, 0}}) {
    Conversation peer(exported);
    peer.receive(bytes);
    EXPECT_TRUE(peer.isOver());
    EXPECT_THAT(peer.reproach(), testing::Not(IsEmpty()));
    EXPECT_THAT(peer.outgoing(), IsEmpty());
  }
  import();
  tell(UsbIpWords::urb(5, false, 1, 70'000));
  EXPECT_THAT(host.reproach(), HasSubstr("64 kB"));
}

TEST_F(Hosted, HangsUpOnAHostThatSubmitsWithoutEndOrReadsNothing) {
  import();
  for (std::uint32_t i = 0; i < 300; ++i) host.receive(UsbIpWords::urb(i, true, 1, 128));
  EXPECT_THAT(host.reproach(), HasSubstr("more transfers waiting"));
  EXPECT_LE(exported.pipes.pending(), Pipes::kMostPending);
  usb::VirtualBoard otherBoard({loadDeviceDescription("vishard10")}, nullptr);
  Export otherExport(otherBoard);
  Conversation deaf(otherExport);
  deaf.receive(UsbIpWords::import("1-1"));
  for (std::uint32_t i = 0; i < 100'000 && !deaf.isOver(); ++i) deaf.receive(UsbIpWords::descriptor(i, 1, 0, 18));
  EXPECT_THAT(deaf.reproach(), HasSubstr("does not take"));
  EXPECT_THAT(deaf.outgoing(), IsEmpty());
}

TEST_F(Hosted, TakesBytesInPiecesOfAnyLength) {
  Bytes all = UsbIpWords::import("1-1");
  const Bytes descriptor = UsbIpWords::descriptor(7, 1, 0, 18);
  all.insert(all.end(), descriptor.begin(), descriptor.end());
  for (const std::uint8_t byte : all) host.receive({&byte, 1});
  EXPECT_THAT(host.outgoing(), SizeIs(8 + 312 + 48 + 18));
}

TEST(VirtualBoard, InFullSpeedSendsAPackedStateAMillisecond) {
  usb::VirtualBoard board({.description = loadDeviceDescription("vishard10"), .form = usb::FrameForm::packed}, nullptr);
  Export exported(board);
  EXPECT_EQ(exported.device.speed, 2u);
  Conversation host(exported);
  host.receive(UsbIpWords::import("1-1"));
  host.receive(UsbIpWords::configure(1));
  host.outgoing().clear();
  for (std::uint32_t i = 0; i < 8; ++i) host.receive(UsbIpWords::urb(10 + i, true, 1, 64));
  for (int i = 0; i < 32; ++i) {
    board.advance();
    host.microframe();
  }
  EXPECT_THAT(host.outgoing(), SizeIs(4 * (48 + usb::kPackedStateSize)));
}

TEST(VirtualBoard, ThatHasJustBeenSwitchedOnStandsAtZeroCounts) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  usb::VirtualBoard lost({.description = description, .homed = false}, nullptr), homed({description}, nullptr);
  EXPECT_EQ(lost.report().reading.encoderCounts, PoseCounts{});
  EXPECT_EQ(homed.report().reading.encoderCounts, description.countsAt(description.homeAngles));
  const PoseCounts home = description.countsAt(description.homeAngles);
  EXPECT_TRUE(lost.port().controlOut(5, usb::bytesOf(home)));
  EXPECT_EQ(lost.report().reading.encoderCounts, home);
}

}  // namespace
}  // namespace haptiv::usbip
