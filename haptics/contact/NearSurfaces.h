#pragma once

#include <array>
#include <cstddef>

#include "haptics/contact/ContactSet.h"

namespace haptiv {

/// A surface near the ball, measured from some place.
struct NearSurface {
  std::int32_t wall;  ///< index into HapticScene::walls
  int face;
  double distance;  ///< [m]
  Vector3 normal;   ///< unit, from the surface to the ball
};

/// A few of them. Nothing is initialised beyond `count`.
struct NearSurfaces {
  static constexpr std::size_t kMost = ContactSet::kMaxContacts;
  std::array<NearSurface, kMost> surface;
  std::size_t count = 0;
};

}  // namespace haptiv
