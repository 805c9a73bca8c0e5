#pragma once

#include <string>

#include "device/described/DeviceDescription.h"

namespace haptiv {

/// The description's text with what is calibrated: sensor.bias, sensor.matrix, encoders.zero, encoders.reference, as
/// far as they differ from what the text has, rounded to what a measurement can tell; comments and all else stay.
///
/// @param calibrated  as it came of loadDeviceDescription, with these changed
/// Throws std::runtime_error where the text cannot be changed so, or would be refused. `sourceName` for messages.
std::string calibratedText(const DeviceDescription& calibrated, const std::string& sourceName);

}  // namespace haptiv
