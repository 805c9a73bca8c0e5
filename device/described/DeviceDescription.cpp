#include "device/described/DeviceDescription.h"

#include "device/Encoder.h"

namespace haptiv {

JointVector DeviceDescription::jointAngles(const DeviceReading& reading) const noexcept {
  const Eigen::Map<const Eigen::Matrix<std::int32_t, kJointCount, 1>> counts(reading.encoderCounts.data());
  return (counts.cast<double>() - encoders.zero).cwiseQuotient(drives.countsPerRadian());
}

PoseCounts DeviceDescription::countsAt(const JointVector& angles) const noexcept {
  const JointVector perRadian = drives.countsPerRadian();
  PoseCounts counts{};
  for (int i = 0; i < kJointCount; ++i)
    counts[static_cast<std::size_t>(i)] = Encoder(perRadian[i], encoders.zero[i]).count(angles[i]);
  return counts;
}

Wrench DeviceDescription::handleWrench(const DeviceReading& reading) const noexcept {
  const Vector6 wrench = sensor.matrix * (sensor.raw(reading.sensorCounts) - sensor.bias);
  return {wrench.head<3>(), wrench.tail<3>()};
}

}  // namespace haptiv
