#pragma once

#include <algorithm>

#include "haptics/contact/MeshNeighbourhood.h"
#include "haptics/contact/NearSurfaces.h"
#include "haptics/planes/HalfSpaces.h"

namespace haptiv {

/// How far a proxy that is held may slip in a tick, beside what the ball moves: part of the radius.
inline constexpr double kSlip = 1.0 / 16;

/// What holds the proxy: exact walls, and then triangles.
using ProxyPlanes = HalfSpaces<2 * ContactSet::kMaxContacts>;

/// The half spaces that surfaces measured from `place` leave to the centre of a ball.
void addPlanes(ProxyPlanes& planes, const NearSurfaces& near, const Vector3& place, double radius) noexcept;

/// The proxy, on its way through a tick.
struct Proxy {
  Vector3 position;       ///< p_WT [m]
  double way;             ///< how far it may still go in this tick while it is held back [m]
  bool isWedged;          ///< goes no farther even where nothing holds it
  NearSurfaces touching;  ///< out: triangles, measured from `position`
  ProxyPlanes planes;     ///< in: the exact walls; out: and then the triangles, each with its share of the way

  /// As far as it may while it is held.
  void goTowards(const Vector3& target) noexcept {
    const Vector3 step = target - position;
    const double length = step.norm();
    position = length > way ? Vector3(position + way / length * step) : target;
    way = std::max(0.0, way - length);
  }
};

/// Brings the proxy towards its goal: straight on while nothing is touched, then along what is touched, to the place
/// next to the goal. It never goes through a triangle, however thin, open or fast passed. Exact walls are half spaces,
/// linear around the proxy. Without contact it comes to its goal in any case.
/// Realtime-safe: yes.
void slide(const HapticScene& scene, MeshNeighbourhood& meshes, const Vector3& goal, double radius,
           Proxy& proxy) noexcept;

}  // namespace haptiv
