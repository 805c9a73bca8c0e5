#pragma once

#include "device/calibration/CalibrationRefused.h"
#include "device/calibration/Samples.h"

namespace haptiv {

inline constexpr std::int64_t kFewestSamples = 200;
inline constexpr double kSteady = 2e-3;  ///< [rad] that a joint may move while something is measured

/// Each throws CalibrationRefused where the samples cannot be relied on.
///
/// Too few of them, or the device was not connected all the time.
void expectWhole(const Samples& samples);
/// A joint moved by more than kSteady.
void expectArmStands(const Samples& samples, const DeviceDescription& description);
/// An axis of the sensor was at the end of its range, does not flicker though its noise is more than half a count, or
/// scatters by more than four times its noise: something touches the handle.
void expectSensorQuiet(const Samples& samples, const HandleSensor& sensor);
/// The means of two parts of one measurement differ by more than chance and half a count: the sensor drifts.
void expectNoDrift(const Samples& first, const Samples& second, const HandleSensor& sensor);

/// "force x", .. "torque z", for messages.
const char* nameOfAxis(int axis);

}  // namespace haptiv
