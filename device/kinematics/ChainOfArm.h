#pragma once

#include "device/described/DeviceDescription.h"

namespace haptiv {

/// The arm of a description as a chain of joints, VISHARD10 too. Its end is the wrist centre C; the tool is not in it.
/// VISHARD10's joints 1 to 5 stand at the height of joint 6, where B is: l5v moves no joint's axis.
/// A parallel arm is no chain: no joints. Allocates: for set-up.
ChainGeometry chainOfArm(const DeviceDescription& description);

}  // namespace haptiv
