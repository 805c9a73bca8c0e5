#include "app/devicecheck/PoseFigures.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "device/redundancy/criterion/Criterion.h"
#include "haptics/safety/Clamps.h"

namespace haptiv {
namespace {

constexpr double kNothing = 1e-9;  // a lever of so little [m, 1] asks nothing of its joint

/// How far a demand can go, of which each joint has this share and has this much to give.
double farthest(const JointVector& share, const JointVector& available) {
  double result = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kJointCount; ++i) {
    if (share[i] > kNothing) result = std::min(result, std::max(0., available[i]) / share[i]);
  }
  return result;
}

JointVector torqueToSpare(const ArmPose& arm, const JointVector& weight, const DeviceDescription& device,
                          double payload) {
  const JointVector carried = weight - payload * arm.J_BT.topRows<3>().transpose() * device.bodies.gravity;
  return device.drives.torqueLimit - device.drives.coulombFriction - carried.cwiseAbs();
}

double speedIn(const ArmPose& arm, const DeviceDescription& device) {
  const Eigen::Matrix<double, 6, 6> gram = arm.J_BT * arm.J_BT.transpose();
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> factors(gram);
  if (!(factors.vectorD().minCoeff() > kNothing * kNothing)) return 0;  // singular
  const Eigen::Matrix<double, 6, 3> linear = factors.solve(Eigen::Matrix<double, 6, 3>::Identity());
  const Eigen::Matrix<double, kJointCount, 3> rates = arm.J_BT.transpose() * linear;
  return farthest(rates.rowwise().norm(), device.drives.rateLimit);
}

double manipulabilityOf(const Jacobian& J) {
  const Eigen::Matrix<double, 6, 6> gram = J * J.transpose();
  return std::sqrt(std::max(0., gram.ldlt().vectorD().cwiseMax(0.).prod()));
}

}  // namespace

PoseFigures figuresOf(const ArmPose& arm, const JointVector& weight, const DeviceDescription& device,
                      const Specification& specification) {
  const Dexterity translation = translationalDexterity(arm.J_BT), rotation = rotationalDexterity(arm.J_BT);
  const JointVector spare = torqueToSpare(arm, weight, device, specification.payload);
  const auto linear = arm.J_BT.topRows<3>();
  const Eigen::Matrix<double, 3, kJointCount> inTool = arm.X_BT.rotation.transpose() * arm.J_BT.bottomRows<3>();

  PoseFigures figures;
  figures.sigmaTranslation = translation.sigma[2];
  figures.sigmaRotation = rotation.sigma[2];
  figures.manipulability = manipulabilityOf(arm.J_BT);
  figures.indexTranslation = translation.directional();
  figures.indexRotation = rotation.directional();
  figures.force = farthest(linear.colwise().norm().transpose(), spare);
  figures.rollTorque = farthest(inTool.row(0).cwiseAbs().transpose(), spare);
  figures.pitchYawTorque = farthest(inTool.bottomRows<2>().colwise().norm().transpose(), spare);
  figures.speed = std::min(speedIn(arm, device), Clamps::kSentShare * device.safety.speedClamp);
  return figures;
}

}  // namespace haptiv
