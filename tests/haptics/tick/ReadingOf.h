#pragma once

#include <cmath>
#include <utility>

#include "device/described/DeviceDescription.h"

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

/// The same with the dead-man released: a session must see it so before it starts.
inline DeviceReading released(DeviceReading reading) {
  reading.inputs = 0;
  return reading;
}

/// An arm without inertia: does exactly what it is told, and is pushed with a constant force (in B, [N]). The
/// dead-man is pressed after the first reading.
class IdealArm : public HapticDevice {
 public:
  IdealArm(const DeviceDescription& description, const JointVector& start, const Vector3& force_T)
      : description_(description), start_(start), force_T_(force_T), q_(start) {}

  void start(double period) override {
    period_ = period;
    q_ = start_;
    pressed_ = false;
    running = true;
  }
  DeviceReading read() noexcept override {
    const DeviceReading reading = readingOf(description_, q_, force_T_);
    return std::exchange(pressed_, true) ? reading : released(reading);
  }
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
  bool pressed_ = false;
};

}  // namespace haptiv::testing
