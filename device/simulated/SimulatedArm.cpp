#include "device/simulated/SimulatedArm.h"

namespace haptiv {
namespace {

DeviceDescription withBodies(DeviceDescription description) {
  if (description.bodies.links.empty() && !description.delta)
    description.bodies.links.resize(static_cast<std::size_t>(description.jointCount()));
  return description;
}

}  // namespace

SimulatedArm::SimulatedArm(const DeviceDescription& description, const JointVector& start, std::uint64_t seed)
    : arm_(description),
      dynamics_(withBodies(description)),
      viscous_(description.drives.viscousFriction),
      coulomb_(description.drives.coulombFriction),
      brakeFriction_(description.drives.brakeFriction),
      hand_(description.hand),
      sensor_(description.sensor, seed),
      hasSensor_(description.type == DeviceType::admittance),
      angles_(start) {
  const JointDrives& all = description.drives;
  const JointVector tunedFor = dynamics_.massMatrix(description.homeAngles).diagonal();
  const JointVector countsPerRadian = all.countsPerRadian();
  for (int i = 0; i < kJointCount; ++i) {
    encoders_.emplace_back(countsPerRadian[i], description.encoders.zero[i]);
    drives_.emplace_back(
        DriveSettings{all.rateLimit[i], all.torqueLimit[i], tunedFor[i], all.bandwidth[i], all.brakeDamping[i]});
  }
}

TorqueLaw SimulatedArm::lawOf(int joint, const DriveDemand& demand, double weight) noexcept {
  JointDrive& drive = drives_[static_cast<std::size_t>(joint)];
  if (demand.braked) return drive.brake();
  return demand.mode == DriveMode::torque ? drive.torque(demand.setPoints[joint])
                                          : drive.rate(demand.setPoints[joint], weight);
}

void SimulatedArm::advance(const DriveDemand& demand, const HandTarget& target, double dt,
                           unsigned deadMotors) noexcept {
  const ArmPose tool = arm_.evaluate(angles_);
  const auto J_linear = tool.J_BT.topRows<3>();
  const auto J_angular = tool.J_BT.bottomRows<3>();
  onTool_B_ = hand_.pull(target, tool.X_BT, {J_linear * rates_, J_angular * rates_}, dt);
  onTool_B_.force += tool.X_BT.rotation * target.load.force;
  onTool_B_.torque += tool.X_BT.rotation * target.load.torque;
  sensor_.follow({tool.X_BT.rotation.transpose() * onTool_B_.force, tool.X_BT.rotation.transpose() * onTool_B_.torque},
                 dt);

  const ArmDynamics::Equation equation = dynamics_.evaluate(angles_, rates_);
  JointStep step{equation.mass, rates_, -equation.bias, viscous_, coulomb_, {}, dt};
  if (demand.braked) step.coulomb += brakeFriction_;
  step.load += J_linear.transpose() * onTool_B_.force + J_angular.transpose() * onTool_B_.torque;
  for (int i = 0; i < kJointCount; ++i) {
    const TorqueLaw law = lawOf(i, demand, equation.bias[i]);
    step.law[static_cast<std::size_t>(i)] = (deadMotors >> i & 1u) != 0 ? TorqueLaw{} : law;
  }
  const JointVector next = step.solve();
  if (!next.allFinite()) return;  // a description of extremes: the arm stands
  for (int i = 0; i < kJointCount; ++i) {
    torques_[i] = step.law[static_cast<std::size_t>(i)].at(next[i]);
    drives_[static_cast<std::size_t>(i)].moved(torques_[i], (next[i] - rates_[i]) / dt, dt);
  }
  angles_ += 0.5 * dt * (rates_ + next);
  rates_ = next;
}

std::array<std::int32_t, kJointCount> SimulatedArm::encoderCounts() const noexcept {
  std::array<std::int32_t, kJointCount> counts;
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = encoders_[i].count(angles_[static_cast<int>(i)]);
  return counts;
}

BoardInputs SimulatedArm::measure() noexcept {
  BoardInputs inputs;
  inputs.encoderCounts = encoderCounts();
  if (hasSensor_) inputs.sensorCounts = sensor_.measure();
  return inputs;
}

}  // namespace haptiv
