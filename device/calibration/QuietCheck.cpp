#include "device/calibration/QuietCheck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>

namespace haptiv {
namespace {

constexpr double kFlickers = 0.5;               // [counts] of noise without which an axis may stand still
constexpr double kMostNoise = 4;                // times that of the description
constexpr double kChance = 6;                   // standard deviations
constexpr double kRoundingVariance = 1 / 12.0;  // variance of a value rounded to counts

std::string text(double number) {
  std::ostringstream out;
  out.precision(3);
  out << number;
  return out.str();
}

const char* unitOf(int axis) {
  return axis < 3 ? " N" : " N m";
}

/// Noise of each axis [counts], that of rounding among it.
Vector6 expectedDeviation(const HandleSensor& sensor) {
  Vector6 noise;
  noise << Vector3::Constant(sensor.forceNoise), Vector3::Constant(sensor.torqueNoise);
  return (noise.cwiseQuotient(sensor.resolution()).array().square() + kRoundingVariance).sqrt();
}

}  // namespace

const char* nameOfAxis(int axis) {
  constexpr std::array kNames = {"force x", "force y", "force z", "torque x", "torque y", "torque z"};
  return kNames.at(static_cast<std::size_t>(axis));
}

void expectWhole(const Samples& samples) {
  if (!samples.connected()) throw CalibrationRefused("the device was disconnected meanwhile; connect it, begin anew");
  if (samples.count() < kFewestSamples)
    throw CalibrationRefused("only " + std::to_string(samples.count()) + " samples; measure longer, " +
                             std::to_string(kFewestSamples) + " are the fewest");
}

void expectArmStands(const Samples& samples, const DeviceDescription& description) {
  const JointVector moved = samples.movement().cwiseQuotient(description.drives.countsPerRadian());
  for (int i = 0; i < description.jointCount(); ++i) {
    if (moved[i] > kSteady)
      throw CalibrationRefused("joint " + std::to_string(i + 1) + " moved by " + text(moved[i]) +
                               " rad meanwhile; let the arm stand, and measure again");
  }
}

void expectSensorQuiet(const Samples& samples, const HandleSensor& sensor) {
  const Vector6 deviation = samples.deviation(), expected = expectedDeviation(sensor), one = sensor.resolution();
  const auto last = sensor.lastCounts();
  for (int i = 0; i < 6; ++i) {
    const std::string axis = std::string("the sensor's ") + nameOfAxis(i);
    const int furthest = std::max(std::abs(int{samples.lowest(i)}), std::abs(int{samples.highest(i)}));
    if (furthest >= last[static_cast<std::size_t>(i)])
      throw CalibrationRefused(axis + " is at the end of its range; take the load off it, or mend its wires");
    const bool flickers = expected[i] * expected[i] - kRoundingVariance >= kFlickers * kFlickers;
    if (flickers && samples.lowest(i) == samples.highest(i))
      throw CalibrationRefused(axis + " says the same again and again; it is dead: mend its wires");
    if (deviation[i] > kMostNoise * expected[i])
      throw CalibrationRefused(axis + " scatters by " + text(deviation[i] * one[i]) + unitOf(i) + ", its noise is " +
                               text(expected[i] * one[i]) + unitOf(i) +
                               "; take the hand off the handle, and let nothing swing");
  }
}

void expectNoDrift(const Samples& first, const Samples& second, const HandleSensor& sensor) {
  const Vector6 drift = second.mean() - first.mean(), one = sensor.resolution();
  const double fewer = static_cast<double>(std::max<std::int64_t>(1, std::min(first.count(), second.count())));
  const Vector6 chance = kChance * std::sqrt(2 / fewer) * expectedDeviation(sensor);
  for (int i = 0; i < 6; ++i) {
    if (std::abs(drift[i]) > chance[i] + 0.5)
      throw CalibrationRefused(std::string("the sensor's ") + nameOfAxis(i) + " drifted by " + text(drift[i] * one[i]) +
                               unitOf(i) +
                               " meanwhile; leave the handle alone, let the sensor warm up, and measure again");
  }
}

}  // namespace haptiv
