#pragma once

#include "device/types.h"

namespace haptiv {

/// Largest factor in [0, 1] by which all rates are to be slowed so that none exceeds its limit; the tool then keeps
/// its direction. Realtime-safe: yes.
double slowDownFactor(const JointVector& rates, const JointVector& rateLimit) noexcept;

}  // namespace haptiv
