#pragma once

#include "haptics/contact/ContactSet.h"

namespace haptiv {

/// The part of the velocity that no wall in contact has to do with: orthogonal to all their normals, in W [m/s].
/// Realtime-safe: yes.
Vector3 freeVelocity(const Vector3& velocity, const ContactSet& contacts) noexcept;

/// The ELSE of the if-then law: f = -b_free v along the directions in which the ball is free   [paper, eq. (28)]
/// Realtime-safe: yes.
inline Vector3 freeMotionForce(const Vector3& velocity, const ContactSet& contacts, double damping) noexcept {
  return -damping * freeVelocity(velocity, contacts);
}

}  // namespace haptiv
