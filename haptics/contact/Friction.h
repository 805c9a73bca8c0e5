#pragma once

#include "haptics/contact/ContactSet.h"

namespace haptiv {

/// Coulomb friction by the cone rule, with the proxy as the thing that sticks.
///
/// The proxy is not drawn to the ball at x but to x + t. Where the proxy sticks, t takes up the ball's motion along the
/// walls: dt = -dx in the directions in which they leave the ball free, so that the proxy stays. The walls press with
/// N = sum k_i d_i, and hold the proxy like one spring of the stiffness k = sum k_i d_i / sum d_i. It sticks while
/// k |t| <= mu_s N; beyond, it slides: it follows with k |t| = mu_d N, and sticks again once the pull is less than
/// that. mu N stands for sum mu_i k_i d_i; a dynamic coefficient above the static one counts as the static one.
/// Where it breaks loose it yields: |t| shrinks by kSlip of the ball's radius in a tick at most, so that a wall that
/// the ball has come into while the proxy stuck to another takes hold of it bit by bit.
///
/// The force k t is continuous in the ball's motion but for these steps from static to dynamic friction, which come to
/// (mu_s - mu_d) N.
/// On one wall it makes, with the normal force, the force k (p - x) of a spring from the ball to the proxy p; a proxy
/// that slides only shortens that spring: friction takes energy, and never gives any.
struct Friction {
  Vector3 offset = Vector3::Zero();  ///< t, in W [m]
  bool sliding = false;
  bool yielding = false;  ///< slides, and t is still longer than dynamic friction would have it
};

/// Friction of the contacts of the tick before, now that the ball has come to where it is. Zero where no wall has any.
/// Realtime-safe: yes.
Friction holdProxy(const HapticScene& scene, const ContactSet& before, const ToolMotion& tool) noexcept;

/// The force of that on the ball, in W [N], within the cone of the contacts as they now are; it is added to theirs.
/// Realtime-safe: yes.
Vector3 frictionForce(const HapticScene& scene, const Friction& friction, ContactSet& contacts) noexcept;

}  // namespace haptiv
