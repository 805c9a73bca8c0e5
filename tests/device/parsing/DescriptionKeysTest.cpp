#include <gtest/gtest.h>

#include "device/described/DeviceDescription.h"

namespace haptiv {
namespace {

constexpr const char* kEveryKey = R"(schema = 1
name = 'small'
[links]
scara = 0.1
forearm = 0.2
lift = 0.3
scaraHeight = 0.4
wristBracket = 1
[sensor]
forceResolution = 1
torqueResolution = 2
forceNoise = 3
torqueNoise = 4
forceRange = 5
torqueRange = 6
bandwidth = 7
[bodies]
gravity = [0, 1, 2]
link = [{mass = 3, centre = [4, 5, 6], inertia = [7, 8, 9, 0.1, 0.2, 0.3]}, {}, {}, {}, {}, {}, {}, {}, {}, {}]
[drives]
brakeDamping = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]
[hand]
mass = 1
gripStiffness = 1000
gripDamping = 12
gripStrength = 13
turnStiffness = 14
turnDamping = 15
peakTorque = 16
stiffness = 7
damping = 8
peakForce = 9
bandwidth = 10
[control]
driftGain = 11
jointGain = 12
singularityDamping = 13
singularityThreshold = 14
trackingErrorLimit = 15
[safety]
watchdogTime = 16
velocityTimeUnit = 0.1
countThreshold = [9e6, 9e6, 9e6, 9e6, 9e6, 9e6, 9e6, 9e6, 9e6, 9e6]
forceClamp = 17
speedClamp = 18
[redundancy]
strategy = 'dir'
solution = 'partitioned'
stepFull = {man = 19, dir = 20, cond = 21}
translationWeight = 22
rotationWeight = 23
weighByRateLimits = true
normalisationPoses = [[1, 2, 3, 4, 5, 6, 7, 8, 9, 10], [0, 0, 0, 0, 0, 0, 0, 0, 0, 0]]
[redundancy.stepPartitioned]
cond = 24
)";

class DescriptionKeys : public testing::Test {
 protected:
  const DeviceDescription d = parseDeviceDescription(kEveryKey, "small.toml");
};

TEST_F(DescriptionKeys, SayWhatTheArmIsBuiltOf) {
  EXPECT_EQ(d.name, "small");
  EXPECT_EQ(Vector3(d.links.scara, d.links.forearm, d.links.lift), Vector3(0.1, 0.2, 0.3));
  EXPECT_EQ(d.links.scaraHeight, 0.4);
  EXPECT_EQ(d.links.wristBracket, 1);
  EXPECT_EQ(d.bodies.gravity, Vector3(0, 1, 2));
  ASSERT_EQ(d.bodies.links.size(), 10u);
  EXPECT_EQ(d.bodies.links[0].mass, 3);
  EXPECT_EQ(d.bodies.links[0].centre, Vector3(4, 5, 6));
  EXPECT_EQ(d.bodies.links[0].inertia, (Matrix3() << 7, 0.1, 0.2, 0.1, 8, 0.3, 0.2, 0.3, 9).finished());
  EXPECT_EQ(d.bodies.links[9].mass, 0);
}

TEST_F(DescriptionKeys, SayHowItIsDrivenAndWhatItFeels) {
  EXPECT_EQ(d.drives.brakeDamping[9], 10);
  EXPECT_EQ(d.sensor.bandwidth, 7);
  EXPECT_EQ(Vector3(d.sensor.forceResolution, d.sensor.forceNoise, d.sensor.forceRange), Vector3(1, 3, 5));
  EXPECT_EQ(Vector3(d.sensor.torqueResolution, d.sensor.torqueNoise, d.sensor.torqueRange), Vector3(2, 4, 6));
}

TEST_F(DescriptionKeys, SayWhoHoldsIt) {
  EXPECT_EQ(Vector3(d.hand.mass, d.hand.gripStiffness, d.hand.gripDamping), Vector3(1, 1000, 12));
  EXPECT_EQ(d.hand.gripStrength, 13);
  EXPECT_EQ(Vector3(d.hand.turnStiffness, d.hand.turnDamping, d.hand.peakTorque), Vector3(14, 15, 16));
  EXPECT_EQ(Eigen::Vector4d(d.hand.stiffness, d.hand.damping, d.hand.peakForce, d.hand.bandwidth),
            Eigen::Vector4d(7, 8, 9, 10));
}

TEST_F(DescriptionKeys, SayHowItIsControlledAndWhatStopsIt) {
  EXPECT_EQ(Vector3(d.control.driftGain, d.control.jointGain, d.control.singularityDamping), Vector3(11, 12, 13));
  EXPECT_EQ(d.control.singularityThreshold, 14);
  EXPECT_EQ(d.control.trackingErrorLimit, 15);
  EXPECT_EQ(Vector3(d.safety.watchdogTime, d.safety.forceClamp, d.safety.speedClamp), Vector3(16, 17, 18));
  EXPECT_EQ(d.safety.velocityTimeUnit, 0.1);
  EXPECT_EQ(d.safety.countThreshold, JointVector::Constant(9e6));
}

TEST_F(DescriptionKeys, SayWhatItsRedundancyServes) {
  EXPECT_EQ(d.redundancy.choice, (ResolutionChoice{Strategy::dir, Solution::partitioned}));
  EXPECT_EQ(Vector3(d.redundancy.stepFull.man, d.redundancy.stepFull.dir, d.redundancy.stepFull.cond),
            Vector3(19, 20, 21));
  EXPECT_EQ(d.redundancy.stepPartitioned.cond, 24);
  EXPECT_EQ(d.redundancy.translationWeight, 22);
  EXPECT_EQ(d.redundancy.rotationWeight, 23);
  EXPECT_TRUE(d.redundancy.weighByRateLimits);
  ASSERT_EQ(d.redundancy.normalisationPoses.size(), 2u);
  EXPECT_EQ(d.redundancy.normalisationPoses[0][9], 10);
}

}  // namespace
}  // namespace haptiv
