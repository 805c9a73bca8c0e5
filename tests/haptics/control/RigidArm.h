#pragma once

#include <functional>
#include <utility>

#include "device/dynamics/ArmDynamics.h"
#include "tests/haptics/tick/ReadingOf.h"

namespace haptiv::testing {

/// An arm of rigid bodies without friction, with drives that give every torque they are told and a wrench on its tool.
/// Rates that are commanded are had at once. The dead-man is pressed after the first reading.
class RigidArm : public HapticDevice {
 public:
  /// The wrench on the tool, in B, at time [s], with the tool at X_BT and its twist in B.
  using OnTool = std::function<Wrench(double time, const Pose& X_BT, const Vector6& twist)>;

  RigidArm(const DeviceDescription& description, const JointVector& start, OnTool onTool)
      : description_(description),
        kinematics_(description),
        dynamics_(description),
        onTool_(std::move(onTool)),
        start_(start) {}

  void start(double period) override {
    period_ = period;
    q = start_;
    rates.setZero();
    wrench_ = {};
    time_ = 0;
    pressed_ = false;
  }

  DeviceReading read() noexcept override {
    const Matrix3 R_TB = kinematics_.forward(q).rotation.transpose();
    DeviceReading reading = readingOf(description_, q, R_TB * wrench_.force);
    const Vector3 counts = R_TB * wrench_.torque / description_.sensor.torqueResolution;
    for (int i = 0; i < 3; ++i)
      reading.sensorCounts[static_cast<std::size_t>(i) + 3] = static_cast<std::int16_t>(std::lround(counts[i]));
    if (!std::exchange(pressed_, true)) reading.inputs = 0;
    return reading;
  }

  void write(const DeviceCommand& command) noexcept override {
    constexpr int kSteps = 4;
    const double dt = period_ / kSteps;
    for (int i = 0; i < kSteps; ++i) step(command, dt);
  }

  void stop() override {}

  JointVector q = JointVector::Zero(), rates = JointVector::Zero();

 private:
  void step(const DeviceCommand& command, double dt) noexcept {
    const ArmPose arm = kinematics_.evaluate(q);
    wrench_ = onTool_(time_, arm.X_BT, arm.J_BT * rates);
    if (!command.enabled) {
      rates.setZero();
    } else if (command.mode == DriveMode::rate) {
      rates = command.jointRates;
    } else {
      rates += dt * dynamics_.accelerations(q, rates, command.jointTorques, wrench_);
    }
    q += dt * rates;
    time_ += dt;
  }

  DeviceDescription description_;
  ArmKinematics kinematics_;
  ArmDynamics dynamics_;
  OnTool onTool_;
  JointVector start_;
  Wrench wrench_;
  double period_ = 0, time_ = 0;
  bool pressed_ = false;
};

}  // namespace haptiv::testing
