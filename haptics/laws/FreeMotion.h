#pragma once

#include "haptics/contact/FreeVelocity.h"

namespace haptiv {

/// The ELSE of the if-then law: f = -b_free v along the directions in which the ball is free   [paper, eq. (28)]
/// Realtime-safe: yes.
inline Vector3 freeMotionForce(const Vector3& velocity, const ContactSet& contacts, double damping) noexcept {
  return -damping * freeVelocity(velocity, contacts);
}

}  // namespace haptiv
