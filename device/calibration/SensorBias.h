#pragma once

#include "device/calibration/Samples.h"

namespace haptiv {

/// What the sensor says of an untouched handle.
struct SensorBias {
  Vector6 bias = Vector6::Zero();       ///< mean [N], [N m]; what becomes sensor.bias
  Vector6 deviation = Vector6::Zero();  ///< standard deviation of one sample [N], [N m]
};

/// From what the device said while the arm stood and nothing touched the handle, in two parts of about the same length.
/// Throws CalibrationRefused where it did not, or the sensor is not well (QuietCheck).
SensorBias findBias(const Samples& first, const Samples& second, const DeviceDescription& description);

}  // namespace haptiv
