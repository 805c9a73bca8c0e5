#pragma once

#include "device/calibration/Samples.h"

namespace haptiv {

/// The encoders' zero as the arm tells it that has been set into its reference pose.
struct FoundZero {
  JointVector zero = JointVector::Zero();    ///< counts at the joints' zero; what becomes encoders.zero
  JointVector change = JointVector::Zero();  ///< of the angles that will be told of the same counts [rad]
};

/// An arm that is set by hand into a pose that pins or marks tell is within this of it [rad].
inline constexpr double kPlausibleChange = 0.2;

/// @param mostChange  of a joint's angle; more is no correction: the arm is not in the reference pose, or the encoders
///                    have lost power since the description's zero was found [rad]
/// Throws CalibrationRefused where the arm did not stand (QuietCheck), or a change is not plausible.
FoundZero findZero(const Samples& samples, const DeviceDescription& description, double mostChange);

}  // namespace haptiv
