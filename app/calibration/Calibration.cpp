#include "app/calibration/Calibration.h"

#include <limits>

#include "device/calibration/QuietCheck.h"
#include "device/parsing/CalibratedText.h"

namespace haptiv {

SensorBias Calibration::takeBias(const QuietMeasurement& measured) {
  const SensorBias found = findBias(measured.first(), measured.second(), description_);
  description_.sensor.bias = found.bias;
  changed_ = true;
  return found;
}

void Calibration::takeLoad(const Vector6& load, const QuietMeasurement& measured) {
  for (const Samples* half : {&measured.first(), &measured.second()}) {
    expectWhole(*half);
    expectArmStands(*half, description_);
    expectSensorQuiet(*half, description_.sensor);
  }
  expectNoDrift(measured.first(), measured.second(), description_.sensor);
  takeLoad(load, 0.5 * (measured.first().mean() + measured.second().mean()));
}

void Calibration::takeLoad(const Vector6& load, const Vector6& counts) {
  loads_.push_back({load, description_.sensor.resolution().cwiseProduct(counts)});
}

SensorMatrix Calibration::takeMatrix() {
  const SensorMatrix found = findMatrix(loads_, description_.sensor.bias, description_.sensor);
  description_.sensor.matrix = found.matrix;
  changed_ = true;
  return found;
}

FoundZero Calibration::takeZero(const QuietMeasurement& measured, bool anew) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  expectWhole(measured.first());
  expectArmStands(measured.first(), description_);
  const FoundZero found = findZero(measured.second(), description_, anew ? kAny : kPlausibleChange);
  description_.encoders.zero = found.zero;
  changed_ = true;
  return found;
}

std::string Calibration::text(const std::string& sourceName) const {
  return calibratedText(description_, sourceName);
}

std::vector<Vector6> standardLoads() {
  constexpr double kForce = 10, kTorque = 0.4;
  std::vector<Vector6> loads;
  for (int axis = 0; axis < 6; ++axis) {
    for (const double way : {1.0, -1.0}) loads.push_back(way * (axis < 3 ? kForce : kTorque) * Vector6::Unit(axis));
  }
  return loads;
}

}  // namespace haptiv
