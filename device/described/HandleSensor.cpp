#include "device/described/HandleSensor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace haptiv {
namespace {

Vector6 perAxis(double force, double torque) {
  Vector6 values;
  values << Vector3::Constant(force), Vector3::Constant(torque);
  return values;
}

}  // namespace

Vector6 HandleSensor::raw(const std::array<std::int16_t, 6>& counts) const noexcept {
  const Eigen::Map<const Eigen::Matrix<std::int16_t, 6, 1>> values(counts.data());
  return resolution().cwiseProduct(values.cast<double>());
}

Vector6 HandleSensor::resolution() const noexcept {
  return perAxis(forceResolution, torqueResolution);
}

Vector6 HandleSensor::range() const noexcept {
  return perAxis(forceRange, torqueRange);
}

std::array<std::int16_t, 6> HandleSensor::lastCounts() const noexcept {
  constexpr double kMost = std::numeric_limits<std::int16_t>::max();
  std::array<std::int16_t, 6> last{};
  for (int i = 0; i < 6; ++i)
    last[static_cast<std::size_t>(i)] =
        static_cast<std::int16_t>(std::min(std::floor(range()[i] / resolution()[i]), kMost));
  return last;
}

}  // namespace haptiv
