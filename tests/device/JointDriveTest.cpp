#include "device/simulated/JointDrive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/Random.h"

namespace haptiv {
namespace {

constexpr DriveLimits kStrong{.rate = 6, .torque = 1e6, .inertia = 1, .bandwidth = 400};
constexpr DriveLimits kWeak{.rate = 6, .torque = 50, .inertia = 0.5, .bandwidth = 400};

TEST(JointDrive, FollowsARateStepWithinItsBandwidth) {
  for (const double dt : {0.25e-3, 0.125e-3}) {
    JointDrive drive(kStrong, 0);
    for (double t = dt; t < 0.05; t += dt) {
      drive.advance(2, 0, dt);
      EXPECT_NEAR(drive.rate(), 2 * (1 - std::exp(-400 * t)), 1e-9);
      // The angle is the integral, but for the trapezium's error: (bandwidth dt)^2 / 12 of the lag, 2 / 400 rad.
      EXPECT_NEAR(drive.angle(), 2 * t - drive.rate() / 400, 5e-3 * 0.01 / 12);
    }
  }
}

TEST(JointDrive, NeverExceedsItsRateAndTorque) {
  test::Random random(1);
  JointDrive drive(kWeak, 0);
  double before = 0;
  for (int i = 0; i < 20000; ++i) {
    drive.advance(random.between(-40, 40), random.between(-49, 49), 0.25e-3);
    EXPECT_LE(std::abs(drive.rate()), kWeak.rate + 1e-12);
    EXPECT_LE(std::abs(drive.torque()), kWeak.torque);
    EXPECT_LE(std::abs(drive.rate() - before), (50 + 49) / 0.5 * 0.25e-3 + 1e-12);
    before = drive.rate();
  }
}

TEST(JointDrive, CarriesALoadWithinItsTorqueAndYieldsToMore) {
  JointDrive drive(kWeak, 0.3);
  for (int i = 0; i < 1000; ++i) drive.advance(0, 49, 0.25e-3);
  EXPECT_NEAR(drive.angle(), 0.3, 1e-12);
  EXPECT_NEAR(drive.torque(), -49, 1e-9);
  for (int i = 0; i < 1000; ++i) drive.advance(0, 60, 0.25e-3);
  // 10 N m too much for 0.25 s at 0.5 kg m^2: half a t squared.
  EXPECT_NEAR(drive.angle(), 0.3 + 0.5 * 20 * 0.25 * 0.25, 1e-6);
}

TEST(JointDrive, BrakesForASetPointThatIsNoNumber) {
  JointDrive drive(kWeak, 0);
  for (int i = 0; i < 400; ++i) drive.advance(2, 0, 0.25e-3);
  for (int i = 0; i < 400; ++i) drive.advance(std::numeric_limits<double>::quiet_NaN(), 0, 0.25e-3);
  EXPECT_NEAR(drive.rate(), 0, 1e-12);
  EXPECT_TRUE(std::isfinite(drive.angle()));
}

}  // namespace
}  // namespace haptiv
