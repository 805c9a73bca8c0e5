#pragma once

#include <cstdint>

#include "device/described/DeviceDescription.h"

namespace haptiv {

/// The same arm as it might have been put together: a sensor with a bias of some newtons and crosstalk of some per
/// cent, encoders whose zero is some hundredths of a radian away. A SimulatedDevice that is built from it is what
/// calibration and homing by the first description have to find. The same for the same seed.
DeviceDescription miscalibrated(const DeviceDescription& description, std::uint64_t seed);

}  // namespace haptiv
