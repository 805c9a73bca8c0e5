/// The host's program ends, or is killed, and is started again while the board goes on: docs/board.md, Commands.
#include "tests/device/usb/bench/UsbBench.h"

namespace haptiv::test {
namespace {

struct RestartedHost : UsbBench {
  RestartedHost() { board->ownSupply = true; }

  /// The next program ticks in place of the one before.
  void tickWith(UsbDevice& host, int count) {
    for (int i = 0; i < count; ++i) {
      reading = host.read();
      host.write(command);
      bus.tick(kIntervals);
    }
    reading = host.read();
  }
  std::uint32_t refused() const { return board->board().report().counters.outOfOrder; }
};

TEST_F(RestartedHost, IsHeardAtOnceForItGoesOnFromTheBoardsOwnNumbers) {
  drive();
  tick(100);
  const DeviceCommand wanted = command;
  command = {};  // what the end of a program says last
  tick(2);
  device.stop();
  command = wanted;
  const std::uint64_t accepted = board->board().report().counters.accepted;
  UsbDevice next{description};
  next.start(1e-3);
  tickWith(next, 20);
  EXPECT_TRUE(reading.connected) << "the board has kept its zero: nothing is to be homed";
  EXPECT_GE(board->board().report().counters.accepted, accepted + 18);
  EXPECT_EQ(refused(), 0u);
  board->buttons = 0;
  tickWith(next, 2);
  board->buttons = kInputDeadMan;
  tickWith(next, 3);
  EXPECT_TRUE(drives());
  EXPECT_EQ(trips(), kNoTrip);
}

TEST_F(RestartedHost, AfterAFreezeWaitsForTheResetToo) {
  drive();
  bus.tick(20 * kIntervals);  // nobody writes
  ASSERT_EQ(trips(), kTripWatchdog);
  device.stop();
  UsbDevice next{description};
  next.start(1e-3);
  tickWith(next, 20);
  EXPECT_EQ(refused(), 0u);
  EXPECT_FALSE(drives());
  board->buttons = 0;
  tickWith(next, 2);
  board->buttons = kInputDeadMan;
  tickWith(next, 3);
  EXPECT_FALSE(drives()) << "the trip is latched, whoever the host is";
  board->buttons = 0;
  tickWith(next, 2);
  next.press(kInputReset);
  tickWith(next, 2);
  next.press(0);
  board->buttons = kInputDeadMan;
  tickWith(next, 3);
  EXPECT_TRUE(drives());
}

}  // namespace
}  // namespace haptiv::test
