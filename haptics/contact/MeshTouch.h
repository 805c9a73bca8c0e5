#pragma once

#include "haptics/contact/MeshNeighbourhood.h"
#include "haptics/contact/NearSurfaces.h"

namespace haptiv {

/// How the proxy, a ball of the tool's radius, meets triangles. A triangle and a ball around its points are convex: the
/// half space through the ball's centre, across the shortest way to the triangle, leaves all of the triangle outside.
/// Both sides of a triangle are alike. All tolerances are parts of the ball's radius.

/// The distance that counts as touching, beyond the ball's radius [m].
double touchTolerance(const Vector3& p_W, double radius) noexcept;

/// The triangles that touch a ball; where none does, the nearest one, if it is about to be touched. Of those of one
/// wall whose normals differ by less than a thousandth only the nearest counts: the ball rolls over inner edges of a
/// flat or finely curved surface as if they were not there. Realtime-safe: yes.
void findTouched(const HapticScene& scene, MeshNeighbourhood& meshes, const Vector3& p_W, double radius,
                 NearSurfaces& touched) noexcept;

/// How far a ball gets on the straight way before it touches a triangle, 0 to `length` [m]. Triangles that it only
/// grazes, entering them no deeper than a thousandth of the way, do not stop it.
///
/// Where the ball goes close by many triangles of a curved surface, the steps to the touch are many: the caller says
/// which ones it need not try.
/// @param out  what the whole way is farther away from than a ball's radius, to within touchTolerance
/// Realtime-safe: yes.
double freeLength(MeshNeighbourhood& meshes, const Vector3& from_W, const Vector3& direction, double length,
                  double radius, const OutOfTheWay& out) noexcept;

}  // namespace haptiv
