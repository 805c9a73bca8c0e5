#pragma once

#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// Carries what differs between `before` and `after`, in what is felt, over to `to`; all else stays, bit for bit.
/// Shapes are told by their order; all of them are taken anew where their number is another. Arm and home stay.
void carryDifference(HapticScene& to, const HapticScene& before, const HapticScene& after);

}  // namespace haptiv
