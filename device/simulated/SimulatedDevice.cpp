#include "device/simulated/SimulatedDevice.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "device/kinematics/ArmKinematics.h"
#include "device/simulated/Encoder.h"
#include "device/simulated/ForceTorqueSensor.h"
#include "device/simulated/HumanHand.h"
#include "device/simulated/JointDrive.h"

namespace haptiv {

namespace {

/// Drives and hand are integrated in steps of at most this [s], so that their motion depends little on the servo's
/// rate.
constexpr double kLongestStep = 0.25e-3;
constexpr double kLongestPeriod = 0.1;

/// What moves, as it is at the beginning of a session.
struct Motion {
  Motion(const DeviceDescription& description, const JointVector& angles, std::uint64_t seed)
      : hand(description.hand), sensor(description.sensor, seed) {
    const JointDrives& all = description.drives;
    for (int i = 0; i < kJointCount; ++i) {
      drives.emplace_back(DriveLimits{all.rateLimit[i], all.torqueLimit[i], all.inertia[i], all.bandwidth[i],
                                      all.viscousFriction[i], all.coulombFriction[i]},
                          angles[i]);
    }
  }

  JointVector angles() const noexcept {
    JointVector q;
    for (int i = 0; i < kJointCount; ++i) q[i] = drives[i].angle();
    return q;
  }
  JointVector rates() const noexcept {
    JointVector w;
    for (int i = 0; i < kJointCount; ++i) w[i] = drives[i].rate();
    return w;
  }

  std::vector<JointDrive> drives;  // never grows after construction
  HumanHand hand;
  ForceTorqueSensor sensor;
  Vector3 handForce = Vector3::Zero();  // on the handle in the last step, in B [N]
};

}  // namespace

struct SimulatedDevice::Parts {
  Parts(const DeviceDescription& newDescription, const JointVector& start, std::unique_ptr<HandSource> hand,
        std::uint64_t newSeed)
      : description(newDescription),
        arm(newDescription),
        source(std::move(hand)),
        seed(newSeed),
        startAngles(start),
        motion(newDescription, start, newSeed) {
    const JointVector countsPerRadian = description.drives.countsPerRadian();
    for (int i = 0; i < kJointCount; ++i) {
      if (!std::isfinite(start[i])) {
        throw std::runtime_error("start angle of joint " + std::to_string(i + 1) + " is not finite; give one in rad");
      }
      encoders.emplace_back(countsPerRadian[i]);
      startAngles[i] = encoders[i].angle(encoders[i].count(start[i]));
    }
    begin();
  }

  void begin();
  void advance(const DeviceCommand& command) noexcept;
  void step(const JointVector& setPoints, const HandTarget& target, double dt) noexcept;
  void measure() noexcept;

  DeviceDescription description;
  ArmKinematics arm;
  std::unique_ptr<HandSource> source;
  std::uint64_t seed;
  JointVector startAngles;
  std::vector<Encoder> encoders;
  Motion motion;
  DeviceReading reading;
  bool running = false;
  double period = 0;
  std::int64_t ticks = 0;
};

void SimulatedDevice::Parts::begin() {
  motion = Motion(description, startAngles, seed);
  ticks = 0;
  reading.inputs = 0;  // a dead-man that is held before the start starts nothing
  measure();
}

void SimulatedDevice::Parts::advance(const DeviceCommand& command) noexcept {
  const JointVector setPoints = command.enabled ? command.jointRates : JointVector(JointVector::Zero());
  const HandTarget target = source ? source->at(static_cast<double>(ticks) * period) : HandTarget{};
  const int steps = static_cast<int>(std::ceil(period / kLongestStep));
  for (int i = 0; i < steps; ++i) step(setPoints, target, period / steps);
  ++ticks;
  reading.inputs = target.inputs;
  measure();
}

void SimulatedDevice::Parts::step(const JointVector& setPoints, const HandTarget& target, double dt) noexcept {
  const JointVector q = motion.angles();
  const ArmPose at = arm.evaluate(q);
  const auto J_linear = at.J_BT.topRows<3>();
  motion.handForce = motion.hand.pull(target, at.X_BT.position, J_linear * motion.rates(), dt);
  const JointVector load = J_linear.transpose() * motion.handForce;
  for (int i = 0; i < kJointCount; ++i) motion.drives[i].advance(setPoints[i], load[i], dt);
}

void SimulatedDevice::Parts::measure() noexcept {
  const JointVector q = motion.angles();
  for (int i = 0; i < kJointCount; ++i) reading.encoderCounts[i] = encoders[i].count(q[i]);
  const Matrix3 R_TB = arm.forward(q).rotation.transpose();
  reading.sensorCounts = motion.sensor.measure({R_TB * motion.handForce, Vector3::Zero()});
}

SimulatedDevice::SimulatedDevice(const DeviceDescription& description, const JointVector& start,
                                 std::unique_ptr<HandSource> hand, std::uint64_t seed)
    : parts_(std::make_unique<Parts>(description, start, std::move(hand), seed)) {}

SimulatedDevice::~SimulatedDevice() = default;

void SimulatedDevice::start(double period) {
  if (!(period > 0 && period <= kLongestPeriod)) {
    throw std::runtime_error("the simulated device cannot run with a period of " + std::to_string(period) +
                             " s; choose a rate of 10 Hz or more");
  }
  parts_->period = period;
  parts_->begin();
  parts_->running = true;
}

DeviceReading SimulatedDevice::read() noexcept {
  return parts_->reading;
}

void SimulatedDevice::write(const DeviceCommand& command) noexcept {
  if (parts_->running) parts_->advance(command);
}

void SimulatedDevice::stop() {
  parts_->running = false;
}

}  // namespace haptiv
