#include "app/devicecheck/PoseFigures.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>

#include "device/dynamics/ArmDynamics.h"
#include "haptics/safety/Clamps.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

constexpr double kPi = std::numbers::pi;

class Arms : public testing::TestWithParam<const char*> {
 protected:
  DeviceDescription device = loadDeviceDescription(GetParam());
  ArmKinematics arm{device};
  Specification specification;
  test::Random random{1};

  JointVector heldAt(const JointVector& q) const {
    return device.bodies.links.empty() ? JointVector(JointVector::Zero()) : ArmDynamics(device).gravity(q);
  }
  /// Of payload and links.
  JointVector carried(const ArmPose& at, const JointVector& q) const {
    return heldAt(q) + at.J_BT.topRows<3>().transpose() * Vector3(0, 0, 9.81 * specification.payload);
  }
  /// Whether the joints can give this much on top of payload and friction; by so much more than rounding.
  bool canGive(const JointVector& torque, const JointVector& weight, double room) const {
    const JointVector most = device.drives.torqueLimit - device.drives.coulombFriction;
    return ((torque.cwiseAbs() + weight.cwiseAbs()).head(device.jointCount()).array() <=
            most.head(device.jointCount()).array() * room)
        .all();
  }
};

TEST_P(Arms, GiveTheForceInEveryDirectionAndNoMoreInTheWorst) {
  for (int i = 0; i < 50; ++i) {
    const auto q = random.vector<JointVector>(-kPi, kPi);
    const ArmPose at = arm.evaluate(q);
    const double force = figuresOf(at, heldAt(q), device, specification).force;
    const JointVector weight = carried(at, q);
    const auto torqueOf = [&](const Vector3& f) { return JointVector(at.J_BT.topRows<3>().transpose() * f); };
    for (int k = 0; k < 20; ++k)
      EXPECT_TRUE(canGive(torqueOf(force * random.vector<Vector3>(-1, 1).normalized()), weight, 1 + 1e-12));
    bool tooMuch = false;  // along the lever of some joint
    for (int joint = 0; joint < device.jointCount(); ++joint) {
      const Vector3 lever = at.J_BT.col(joint).head<3>();
      if (lever.norm() > 1e-6) tooMuch |= !canGive(torqueOf(1.001 * force * lever.normalized()), weight, 1);
    }
    EXPECT_TRUE(tooMuch || force == 0);
  }
}

TEST_P(Arms, MoveAtTheSpeedInEveryDirectionWithoutTurning) {
  for (int i = 0; i < 50; ++i) {
    const ArmPose at = arm.evaluate(random.vector<JointVector>(-kPi, kPi));
    device.safety.speedClamp = 100;
    const double speed = figuresOf(at, JointVector::Zero(), device, specification).speed;
    for (int k = 0; k < 20; ++k) {
      Vector6 twist = Vector6::Zero();
      twist.head<3>() = speed * random.vector<Vector3>(-1, 1).normalized();
      const JointVector rates = at.J_BT.completeOrthogonalDecomposition().solve(twist);
      EXPECT_LE(rates.cwiseAbs().cwiseQuotient(device.drives.rateLimit).maxCoeff(), 1 + 1e-6);
    }
  }
}

TEST_P(Arms, TellWhenTheyAreStretchedOut) {
  const PoseFigures figures = figuresOf(arm.evaluate(JointVector::Zero()), JointVector::Zero(), device, specification);
  EXPECT_LT(figures.manipulability, 1e-6);  // a root: rounding of 1e-16 is 1e-8
  EXPECT_EQ(figures.speed, 0);
}

TEST_P(Arms, AreNoFasterThanTheyAreSent) {
  device.safety.speedClamp = 0.01;
  EXPECT_EQ(figuresOf(arm.evaluate(device.homeAngles), JointVector::Zero(), device, specification).speed,
            Clamps::kSentShare * 0.01);
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, Arms, testing::Values("vishard10", "anthropomorphic7"));

}  // namespace
}  // namespace haptiv
