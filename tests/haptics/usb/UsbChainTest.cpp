/// The whole chain over USB: hand, arm and board behind a virtual bus, real libusb, the tick.
#include <gtest/gtest.h>

#include "device/simulated/ScriptedHand.h"
#include "haptics/servo/FastLoop.h"
#include "tests/device/usb/bench/BenchedUsbDevice.h"
#include "tests/haptics/usb/WallBeforeHome.h"

namespace haptiv::test {
namespace {

class UsbChain : public testing::TestWithParam<UsbSpeed> {};

TEST_P(UsbChain, RestsAsDeepInTheWallAsTheHandPushes) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const WallBeforeHome wall(description);
  BenchedUsbDevice device(description, GetParam(), wall.pushedBy(20));
  Vector3 force = Vector3::Zero();
  double depth = 0;
  constexpr int kTicks = 3000, kMean = 500;
  int tick = 0;
  runFast(device, description, 1000, wall.scene(), kTicks, [&](const TickRecord& record) {
    EXPECT_EQ(record.faults, kNoFault) << "tick " << record.tick;
    if (++tick > kTicks - kMean) {
      force += record.handForce / kMean;
      depth += wall.depthOf(record.position) / kMean;
    }
    return record.faults == kNoFault;
  });
  EXPECT_EQ(tick, kTicks);
  EXPECT_NEAR(force.x(), 20, 0.02 * 20);    // noise and dry friction, as for the simulated device
  EXPECT_NEAR(depth, 0.010, 0.02 * 0.010);  // 20 N / 2000 N/m
  EXPECT_EQ(device.board().unsafe, 0);
}

TEST_P(UsbChain, StopsInTheTickThatFindsTheBoardUnplugged) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const WallBeforeHome wall(description);
  BenchedUsbDevice device(description, GetParam(), wall.pushedBy(20));
  int tick = 0, stoppedAt = 0;
  runFast(device, description, 1000, wall.scene(), 500, [&](const TickRecord& record) {
    if (++tick == 400) device.bus().unplug(device.port());
    if (stoppedAt == 0 && (record.faults & kFaultDisconnected) != 0) stoppedAt = tick;
    EXPECT_TRUE(stoppedAt == 0 || !record.command.enabled);
    return true;
  });
  EXPECT_EQ(stoppedAt, 401);
}

/// The slowest and the fastest rate [rad/s] that is measured of a joint which turns steadily at 0.3 rad/s; with states
/// lost in between, for two ticks in a row, after which the host does not yet slow the arm, and for one.
std::pair<double, double> measuredRates(UsbSpeed speed, bool lossy) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const Measuring measure(description, 1e-3);
  BenchedUsbDevice device(description, speed);
  device.start(1e-3);
  MeasuringState state;
  DeviceCommand command;
  std::pair<double, double> rates{1, 0};
  const int perTick = speed == UsbSpeed::high ? 8 : 1;
  for (int tick = 0; tick < 600; ++tick) {
    command.enabled = tick >= 5;
    if (command.enabled) command.jointRates[0] = 0.3;
    if (lossy && tick % 100 == 50) device.port().faults.lose = 2 * perTick;
    if (lossy && tick % 100 == 80) device.port().faults.lose = perTick;
    const double rate = measure({}, device.read(), state).rates[0];
    if (tick > 300) rates = {std::min(rates.first, rate), std::max(rates.second, rate)};  // it is up to speed
    device.write(command);
  }
  device.stop();
  return rates;
}

TEST_P(UsbChain, MissingStatesMakeNoJointLookFast) {
  const auto [slowest, fastest] = measuredRates(GetParam(), false);
  EXPECT_NEAR(slowest, 0.3, 0.04);  // the encoder's steps, behind the low-pass
  EXPECT_NEAR(fastest, 0.3, 0.04);
  const auto [slowestOfLossy, fastestOfLossy] = measuredRates(GetParam(), true);
  constexpr double kSame = 0.005;
  EXPECT_GT(slowestOfLossy, slowest - kSame);
  EXPECT_LT(fastestOfLossy, fastest + kSame);
}

INSTANTIATE_TEST_SUITE_P(Speeds, UsbChain, testing::Values(UsbSpeed::high, UsbSpeed::full),
                         [](const auto& speed) { return speed.param == UsbSpeed::high ? "HighSpeed" : "FullSpeed"; });

}  // namespace
}  // namespace haptiv::test
