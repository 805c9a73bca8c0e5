#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "device/simulated/Noise.h"
#include "haptics/safety/OscillationMonitor.h"
#include "haptics/safety/RunawayMonitor.h"

namespace haptiv {
namespace {

/// Sine of this frequency, each half swing `keeps` times the one before.
struct Swing {
  double hertz = 60, amplitude = 0, keeps = 1;
  double at(double t) const {
    return amplitude * std::pow(keeps, 2 * hertz * t) * std::sin(2 * std::numbers::pi * hertz * t);
  }
};

/// What else goes on while it swings.
struct Meanwhile {
  double speed = 0;  ///< of the ball's way [m/s]
  double power = 0;  ///< into the display [W]
};

/// Faults of two seconds of a velocity [m/s] and a force [N] that swing.
std::uint32_t watch(const Swing& velocity, const Swing& force, const Meanwhile& meanwhile = {}, double rate = 1000) {
  SafetyThresholds safety;
  safety.oscillationSpeed = 0.05;
  safety.forceClamp = 170;
  const OscillationMonitor monitor(safety, 1 / rate);
  OscillationState state;
  std::uint32_t faults = kNoFault;
  for (int i = 0; i < 2 * rate; ++i) {
    const double t = i / rate;
    faults |= monitor(
        {Vector3(meanwhile.speed, velocity.at(t), 0), Vector3(0, force.at(t) - 20, 0), meanwhile.power * t}, state);
  }
  return faults;
}

TEST(OscillationMonitorTest, FindsSwingsOfTheBallThatDoNotDieDown) {
  for (const double rate : {500., 1000., 8000.}) {
    EXPECT_EQ(watch({30, 0.1}, {}, {}, rate), kFaultOscillation);
    EXPECT_EQ(watch({100, 0.07}, {}, {}, rate), kFaultOscillation);
  }
  EXPECT_EQ(watch({40, 1e-2, 1.05}, {}), kFaultOscillation);  // that grow
}

TEST(OscillationMonitorTest, FindsSwingsOfTheForceHoweverLittleTheBallMoves) {
  for (const double rate : {500., 1000., 8000.}) EXPECT_EQ(watch({100, 0.01}, {100, 20}, {}, rate), kFaultOscillation);
}

TEST(OscillationMonitorTest, LeavesAloneTremorAndRingingAndWhatIsSmall) {
  EXPECT_EQ(watch({4, 0.3}, {4, 60}), kNoFault);               // as fast as a hand goes to and fro
  EXPECT_EQ(watch({60, 1.0, 0.9}, {60, 100, 0.9}), kNoFault);  // after an impact
  EXPECT_EQ(watch({60, 0.03}, {60, 5}), kNoFault);
}

TEST(OscillationMonitorTest, LeavesAloneWhatTheHandFeelsOfARoughGround) {
  EXPECT_EQ(watch({60, 0.03}, {60, 20}, {.speed = 0.1, .power = 0.5}), kNoFault);
  EXPECT_EQ(watch({60, 0.08}, {60, 60}, {.speed = 0.5, .power = 0.5}), kNoFault);
}

TEST(OscillationMonitorTest, FindsSwingsThatTheDisplayFeedsWhileTheBallGoesOn) {
  EXPECT_EQ(watch({60, 0.03}, {60, 20}, {.speed = 0.1, .power = -0.5}), kFaultOscillation);
}

TEST(OscillationMonitorTest, IsNotAlarmedByABallThatIsMerelyDriven) {
  SafetyThresholds safety;
  const OscillationMonitor monitor(safety, 1e-3);
  OscillationState state;
  for (int i = 0; i < 500; ++i) {
    const double t = i * 1e-3;
    EXPECT_EQ(monitor({Vector3(15 * t, 0, 0), Vector3(300 * t, 0, 0), -t}, state), kNoFault);
  }
}

/// Faults of a mass that is held at its clamp for a tenth of a second while the hand pushes so, with this noise [N].
std::uint32_t runaway(double push, double noise) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const RunawayMonitor monitor(description, 1e-3);
  Noise sensor(1);
  double time = 0;
  std::uint32_t faults = kNoFault;
  for (int i = 0; i < 100; ++i)
    faults |= monitor(kClampSpeed, Vector3(1.2, 0, 0), Vector3(push + noise * sensor.next(), 0, 0), time);
  return faults;
}

TEST(RunawayMonitorTest, FindsAMassThatStaysAtItsClampWithoutAHand) {
  for (const double noise : {0., 0.02}) {
    EXPECT_EQ(runaway(20, noise), kNoFault);
    EXPECT_EQ(runaway(0, noise), kFaultRunaway);
    EXPECT_EQ(runaway(-20, noise), kFaultRunaway);
  }
}

}  // namespace
}  // namespace haptiv
