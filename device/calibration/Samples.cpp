#include "device/calibration/Samples.h"

#include <algorithm>
#include <cmath>

namespace haptiv {

void Samples::take(const DeviceReading& reading) noexcept {
  if (count_ == 0) {
    lowest_ = highest_ = reading.sensorCounts;
    least_ = most_ = reading.encoderCounts;
  }
  ++count_;
  connected_ = connected_ && reading.connected;
  for (std::size_t i = 0; i < sum_.size(); ++i) {
    const std::int16_t value = reading.sensorCounts[i];
    sum_[i] += value;
    squares_[i] += std::int64_t{value} * value;
    lowest_[i] = std::min(lowest_[i], value);
    highest_[i] = std::max(highest_[i], value);
  }
  newest_ = reading.encoderCounts;
  for (std::size_t i = 0; i < newest_.size(); ++i) {
    least_[i] = std::min(least_[i], newest_[i]);
    most_[i] = std::max(most_[i], newest_[i]);
  }
}

Vector6 Samples::mean() const noexcept {
  Vector6 mean = Vector6::Zero();
  if (count_ == 0) return mean;
  for (int i = 0; i < 6; ++i)
    mean[i] = static_cast<double>(sum_[static_cast<std::size_t>(i)]) / static_cast<double>(count_);
  return mean;
}

Vector6 Samples::deviation() const noexcept {
  Vector6 deviation = Vector6::Zero();
  if (count_ < 2) return deviation;
  const Vector6 mean = this->mean();
  for (int i = 0; i < 6; ++i) {
    const double about = static_cast<double>(squares_[static_cast<std::size_t>(i)]) / static_cast<double>(count_);
    deviation[i] = std::sqrt(std::max(0.0, about - mean[i] * mean[i]));
  }
  return deviation;
}

JointVector Samples::movement() const noexcept {
  JointVector movement;
  for (std::size_t i = 0; i < most_.size(); ++i)
    movement[static_cast<int>(i)] = static_cast<double>(most_[i]) - static_cast<double>(least_[i]);
  return movement;
}

}  // namespace haptiv
