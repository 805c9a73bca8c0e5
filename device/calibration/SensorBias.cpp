#include "device/calibration/SensorBias.h"

#include <cmath>

#include "device/calibration/QuietCheck.h"

namespace haptiv {

SensorBias findBias(const Samples& first, const Samples& second, const DeviceDescription& description) {
  for (const Samples* part : {&first, &second}) {
    expectWhole(*part);
    expectArmStands(*part, description);
    expectSensorQuiet(*part, description.sensor);
  }
  expectNoDrift(first, second, description.sensor);
  const Vector6 one = description.sensor.resolution();
  const SensorBias found{0.5 * one.cwiseProduct(first.mean() + second.mean()),
                         one.cwiseProduct(first.deviation().cwiseMax(second.deviation()))};
  const Vector6 most = 0.5 * description.sensor.range();
  for (int i = 0; i < 6; ++i) {
    if (std::abs(found.bias[i]) > most[i])
      throw CalibrationRefused(
          std::string("the sensor's ") + nameOfAxis(i) +
          " is beyond half of its range with nothing at the handle; mend or mount the sensor anew");
  }
  return found;
}

}  // namespace haptiv
