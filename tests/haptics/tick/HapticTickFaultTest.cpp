#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/haptics/tick/HapticTickFixture.h"

namespace haptiv {
namespace {

using testing::HapticTickTest;
using testing::readingOf;

class HapticTickFault : public HapticTickTest {
 protected:
  HapticTickFault() {
    scene.resolution = ResolutionChoice{Strategy::nonopt, Solution::full};  // no self-motion, which this arm would miss
  }
  void expectLatched(TickState& state, std::uint32_t fault) { expectLatched(state, fault, start); }
  void expectLatched(TickState& state, std::uint32_t fault, const JointVector& q) {
    const JointVector held = state.control.desiredAngles;
    for (int i = 0; i < 10; ++i) {
      const TickRecord record = tick(scene, readingOf(description, q), state);
      EXPECT_EQ(record.faults & fault, fault);
      EXPECT_FALSE(record.command.enabled);
      EXPECT_EQ(record.command.jointRates, JointVector(JointVector::Zero()));
      EXPECT_EQ(record.desiredAngles, held);
      EXPECT_EQ(record.environmentForce, Vector3::Zero());
      EXPECT_TRUE(record.position.allFinite() && record.desiredPosition.allFinite());
    }
  }
  TickState running() const {
    TickState state = ready();
    for (int i = 0; i < 5; ++i) tick(scene, readingOf(description, start), state);
    return state;
  }
  /// The joint is turned away over some ticks, no faster than it may.
  TickRecord turnAway(int joint, double angle, JointVector& q, TickState& state) const {
    TickRecord record;
    constexpr int kTicks = 60;  // and the tool no faster than 0.5 m/s
    for (int i = 0; i < kTicks; ++i) {
      q[joint] += angle / kTicks;
      record = tick(scene, readingOf(description, q), state);
    }
    return record;
  }
};

TEST_F(HapticTickFault, LatchesWhereAPropertyOfTheSceneIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<HapticScene> bad(4, scene);
  bad[0].tool.mass = nan;
  bad[1].walls[0].surface.stiffness = nan;
  bad[1].walls[0].shape.centre.x() -= 0.01;
  bad[2].device.position.x() = nan;
  bad[3].tool.mass = 0;
  for (HapticScene& now : bad) {
    ++now.version;
    computeBounds(now);
    TickState state = running();
    const TickRecord record = tick(now, readingOf(description, start, inTool({1, 0, 0})), state);
    EXPECT_EQ(record.faults, kFaultNotFinite);
    EXPECT_FALSE(record.command.enabled);
    expectLatched(state, kFaultNotFinite);
  }
}

TEST_F(HapticTickFault, LatchesWhereTheDeviceIsGone) {
  TickState state = running();
  DeviceReading reading = readingOf(description, start);
  reading.connected = false;
  EXPECT_FALSE(tick(scene, reading, state).command.enabled);
  expectLatched(state, kFaultDisconnected);
}

TEST_F(HapticTickFault, LatchesWhereTheSensorIsAtTheEndOfItsRange) {
  for (const int sign : {-1, 1}) {
    for (std::size_t axis = 0; axis < 6; ++axis) {
      TickState state = running();
      DeviceReading reading = readingOf(description, start);
      const HandleSensor& sensor = description.sensor;
      const double last = axis < 3 ? sensor.forceRange / sensor.forceResolution : 30000;
      reading.sensorCounts[axis] = static_cast<std::int16_t>(sign * last);
      tick(scene, reading, state);
      expectLatched(state, kFaultSensorSaturated);
    }
  }
}

TEST_F(HapticTickFault, LatchesWhereAJointIsNotWhereItWasSent) {
  for (int joint = 0; joint < kJointCount; ++joint) {
    TickState state = running();
    JointVector q = start;
    EXPECT_EQ(turnAway(joint, 1.2 * description.control.trackingErrorLimit, q, state).faults, kFaultTracking);
    expectLatched(state, kFaultTracking, q);
  }
}

TEST_F(HapticTickFault, TakesASmallTrackingErrorBackInsteadOfLatching) {
  TickState state = running();
  JointVector q = start;
  const TickRecord record = turnAway(2, 0.5 * description.control.trackingErrorLimit, q, state);
  EXPECT_EQ(record.faults, kNoFault);
  EXPECT_LT(record.command.jointRates[2], 0);
}

TEST(FaultName, NamesEveryFaultThatStands) {
  EXPECT_STREQ(faultName(kNoFault), "none");
  EXPECT_STREQ(faultName(kFaultTracking), "tracking error");
  EXPECT_EQ(faultList(kFaultNotFinite | kFaultDisconnected), "not finite, device disconnected");
  EXPECT_EQ(faultList(kNoFault), "none");
}

}  // namespace
}  // namespace haptiv
