#include "device/simulated/Miscalibration.h"

#include <algorithm>
#include <cmath>

#include "device/simulated/Noise.h"

namespace haptiv {
namespace {

constexpr double kBias = 0.01;       // of the range
constexpr double kCrosstalk = 0.02;  // of an axis' range on another's
constexpr double kZero = 0.03;       // [rad]
constexpr double kMost = 3;          // times these

}  // namespace

DeviceDescription miscalibrated(const DeviceDescription& description, std::uint64_t seed) {
  DeviceDescription built = description;
  Noise noise(seed);
  const auto draw = [&noise](double deviation) { return deviation * std::clamp(noise.next(), -kMost, kMost); };
  const Vector6 range = description.sensor.range();
  Matrix6 crosstalk;
  for (int i = 0; i < 6; ++i) {
    built.sensor.bias[i] += draw(kBias * range[i]);
    for (int j = 0; j < 6; ++j) crosstalk(i, j) = draw(kCrosstalk) * range[i] / range[j];
  }
  built.sensor.matrix = (Matrix6::Identity() + crosstalk) * description.sensor.matrix;
  const JointVector perRadian = description.drives.countsPerRadian();
  for (int i = 0; i < description.jointCount(); ++i) built.encoders.zero[i] += std::round(draw(kZero) * perRadian[i]);
  return built;
}

}  // namespace haptiv
