#pragma once

#include <cmath>

#include "device/DeviceDescription.h"

namespace haptiv::testing {

/// What a device of this description reports at these joint angles, with this force on its handle (in T).
inline DeviceReading readingOf(const DeviceDescription& description, const JointVector& q,
                               const Vector3& force_T = Vector3::Zero()) {
  const JointVector countsPerRadian = description.drives.countsPerRadian();
  DeviceReading reading;
  for (int i = 0; i < kJointCount; ++i) {
    reading.encoderCounts[static_cast<std::size_t>(i)] =
        static_cast<std::int32_t>(std::lround(q[i] * countsPerRadian[i]));
  }
  for (int i = 0; i < 3; ++i) {
    reading.sensorCounts[static_cast<std::size_t>(i)] =
        static_cast<std::int16_t>(std::lround(force_T[i] / description.sensor.forceResolution));
  }
  return reading;
}

/// An arm without inertia: does exactly what it is told, and is pushed with a constant force (in B, [N]).
class IdealArm : public HapticDevice {
 public:
  IdealArm(const DeviceDescription& description, const JointVector& start, const Vector3& force_T)
      : description_(description), start_(start), force_T_(force_T), q_(start) {}

  void start(double period) override {
    period_ = period;
    q_ = start_;
    running = true;
  }
  DeviceReading read() noexcept override { return readingOf(description_, q_, force_T_); }
  void write(const DeviceCommand& command) noexcept override {
    if (command.enabled) q_ += period_ * command.jointRates;
  }
  void stop() override { running = false; }

  bool running = false;

 private:
  DeviceDescription description_;
  JointVector start_;
  Vector3 force_T_;
  JointVector q_;
  double period_ = 0;
};

}  // namespace haptiv::testing
