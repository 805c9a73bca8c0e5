#pragma once

#include "haptics/contact/ContactSet.h"

namespace haptiv {

/// The part of the velocity that no wall in contact has to do with: orthogonal to all their normals, in W [m/s].
/// Realtime-safe: yes.
Vector3 freeVelocity(const Vector3& velocity, const ContactSet& contacts) noexcept;

}  // namespace haptiv
