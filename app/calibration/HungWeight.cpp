#include "app/calibration/HungWeight.h"

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "device/calibration/CalibrationRefused.h"
#include "device/calibration/QuietCheck.h"
#include "device/calibration/SensorMatrix.h"

namespace haptiv {
namespace {

void expectWithin(const Vector6& load, std::size_t number, const Vector6& range) {
  for (int axis = 0; axis < 6; ++axis) {
    if (std::abs(load[axis]) <= range[axis]) continue;  // not for a number that is none
    throw CalibrationRefused("load " + std::to_string(number) + ": its " + nameOfAxis(axis) +
                             " is beyond what the sensor measures, " + std::to_string(range[axis]) +
                             (axis < 3 ? " N" : " N m") + "; make it less");
  }
}

}  // namespace

Vector6 loadOf(const HungWeight& weight) {
  const Vector3 force = weight.mass * kStandardGravity * weight.down;
  Vector6 load;
  load << force, weight.place.cross(force);
  return load;
}

double expectTelling(std::span<const Vector6> loads, const HandleSensor& sensor) {
  std::vector<LoadCase> cases;
  for (const Vector6& load : loads) {
    expectWithin(load, cases.size() + 1, sensor.range());
    cases.push_back({load, load});  // as a sensor without a fault would measure it
  }
  return findMatrix(cases, Vector6::Zero(), sensor).condition;
}

}  // namespace haptiv
