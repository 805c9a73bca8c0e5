/// States gather after a command, and are taken shortly before the servo reads: nothing else waits for that.
#include "device/usb/host/StatePace.h"
#include "tests/device/usb/bench/UsbBench.h"

namespace haptiv::test {
namespace {

struct Gathering : UsbBench {
  /// Begins a tick after whose command states gather: one that is not timed. Half of it passes.
  void halfATick() {
    drive();
    for (int i = 0; i < 8; ++i) {
      device.read();
      device.write(command);
      bus.tick();  // an echo that is waited for has come
      const std::uint64_t before = figures().states;
      bus.tick(kIntervals / 2 - 1);
      if (figures().states == before) return;
      bus.tick(kIntervals / 2);
    }
    FAIL() << "no state gathers";
  }
};

TEST_F(Gathering, StatesAreTakenShortlyBeforeTheServoReads) {
  halfATick();
  const std::uint64_t before = figures().states;
  bus.tick(kIntervals / 2);
  EXPECT_EQ(figures().states, before + kIntervals);
  EXPECT_EQ(figures().missing, 0u);
  EXPECT_EQ(device.read().deviceTime, board->board().report().time) << "the newest one";
}

TEST_F(Gathering, OnlyEveryEighthEchoIsWaitedFor) {
  drive();
  int waited = 0;
  for (int i = 0; i < 80; ++i) {
    device.read();
    device.write(command);
    const std::uint64_t before = figures().states;
    bus.tick();
    waited += figures().states > before ? 1 : 0;
    bus.tick(kIntervals - 1);
  }
  EXPECT_EQ(waited, 10);
  EXPECT_EQ(device.latencies().total, 10u);
}

TEST_F(Gathering, ACommandGoesOutAtOnce) {
  halfATick();
  const std::uint32_t accepted = board->board().report().counters.accepted;
  for (std::uint32_t more = 1; more <= 5; ++more) {  // many more than there are transfers for
    device.write(command);
    bus.tick();
    EXPECT_EQ(board->board().report().counters.accepted, accepted + more);
  }
  EXPECT_EQ(figures().skipped, 0u);
}

TEST_F(Gathering, UnpluggingIsFoundAtOnce) {
  halfATick();
  bus.unplug(*port);
  EXPECT_FALSE(device.read().connected);
  EXPECT_EQ(figures().losses, 1u);
}

TEST_F(Gathering, WithoutCommandsEachStateIsTakenAsItComes) {
  halfATick();
  bus.tick(kIntervals);
  for (int i = 0; i < 20; ++i) {
    const std::uint64_t before = figures().states;
    bus.tick();
    EXPECT_EQ(figures().states, before + 1);
  }
}

TEST(StatePaceTest, StatesGatherOnlyWhereThatSavesWakeUps) {
  const usb::StatePace atOneKilohertz = usb::statePace(1e-3, usb::FrameForm::full);
  EXPECT_EQ(atOneKilohertz.rest.count(), 890);
  EXPECT_GE(atOneKilohertz.ahead * 125, 890 + 125) << "the bus never waits";
  const usb::StatePace atTenHertz = usb::statePace(0.1, usb::FrameForm::full);
  EXPECT_LE(atTenHertz.rest.count(), 5000) << "well within the time in which silence is told";
  EXPECT_GE(atTenHertz.ahead * 125, atTenHertz.rest.count() + 125);
  for (const double period : {0.25e-3, 0.125e-3, 0.})
    EXPECT_EQ(usb::statePace(period, usb::FrameForm::full).rest.count(), 0) << period;
  EXPECT_EQ(usb::statePace(1e-3, usb::FrameForm::packed).rest.count(), 0);
}

}  // namespace
}  // namespace haptiv::test
