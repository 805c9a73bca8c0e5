#pragma once

#include <functional>

#include "app/experiments/RunResult.h"
#include "device/described/DeviceDescription.h"
#include "device/redundancy/RedundancyResolution.h"

namespace haptiv {

inline constexpr double kTick = 1e-3;   ///< [s]
inline constexpr int kSampleTicks = 5;  ///< from one sample to the next

/// Runs the arm along the path by closed-loop inverse kinematics at 1 kHz: each tick's wanted twist is the step to the
/// next wanted pose over the tick's length, plus the drift correction, and the joint rates are held for the tick.
/// The joint limiter is not in the loop: rates beyond the limits would show.
///
/// @param resolution  of deviceFor(setup.experiment, device)
/// Deterministic: the same setup gives the same bits.
RunResult simulate(const RunSetup& setup, const DeviceDescription& device, const RedundancyResolution& resolution);

}  // namespace haptiv
