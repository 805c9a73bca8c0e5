#pragma once

#include "haptics/geometry/SurfacePoint.h"
#include "haptics/meshes/TriangleMesh.h"

namespace haptiv {

/// Nearest point of a mesh. For a closed mesh the distance is negative inside and the normal points outwards; for an
/// open one, of which both sides are alike, the distance is not negative and the normal points to p_W.
/// `face` is the triangle. A mesh without triangles is infinitely far.
///
/// Inside or outside is told by the angle-weighted normal in the nearest point, which is right on edges and corners
/// too, where the normal of any one triangle need not be (Baerentzen and Aanaes, 2005).
/// Realtime-safe: yes.
SurfacePoint nearestOnMesh(const TriangleMesh& mesh, const Vector3& p_W) noexcept;

/// The same of one triangle, both sides alike; for a triangle that is not there, infinitely far. Realtime-safe: yes.
SurfacePoint onMeshFace(const TriangleMesh& mesh, const Vector3& p_W, int face) noexcept;

/// Unit normal of a triangle as its corners turn; some direction where it has no area. Realtime-safe: yes.
Vector3 faceNormal(const TriangleMesh& mesh, std::size_t triangle) noexcept;

}  // namespace haptiv
