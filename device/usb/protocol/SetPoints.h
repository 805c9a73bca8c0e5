#pragma once

#include "device/types.h"
#include "device/usb/protocol/StreamFrames.h"

namespace haptiv::usb {

/// A set-point as an integer of the wire. The smallest integer says: no number.
std::int64_t toWire(double value, DriveMode mode, FrameForm form) noexcept;
/// The other way; what says "no number" becomes NaN.
double fromWire(std::int64_t value, DriveMode mode, FrameForm form) noexcept;

}  // namespace haptiv::usb
