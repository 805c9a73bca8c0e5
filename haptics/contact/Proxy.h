#pragma once

#include "haptics/HalfSpaces.h"
#include "haptics/contact/MeshNeighbourhood.h"
#include "haptics/contact/NearSurfaces.h"

namespace haptiv {

/// What holds the proxy: exact walls, and then triangles.
using ProxyPlanes = HalfSpaces<2 * ContactSet::kMaxContacts>;

/// The half spaces that surfaces measured from `place` leave to the centre of a ball.
void addPlanes(ProxyPlanes& planes, const NearSurfaces& near, const Vector3& place, double radius) noexcept;

/// The proxy, on its way through a tick.
struct Proxy {
  Vector3 position;       ///< p_WT [m]
  double way;             ///< how far it may still go in this tick while it is held back [m]
  NearSurfaces touching;  ///< out: triangles, measured from `position`
  ProxyPlanes planes;     ///< out: the exact walls and then the triangles, each with its share of the way from the goal
};

/// Brings the proxy towards its goal: straight on while nothing is touched, then along what is touched, to the place
/// next to the goal. It never goes through a triangle, however thin, open or fast passed. Exact walls are given as half
/// spaces, linear around the proxy. Without contact it comes to its goal in any case.
/// Realtime-safe: yes.
void slide(const HapticScene& scene, const MeshNeighbourhood& meshes, const ProxyPlanes& walls, const Vector3& goal,
           double radius, Proxy& proxy) noexcept;

}  // namespace haptiv
