#pragma once

#include <vector>

#include "haptics/meshes/TriangleMesh.h"

namespace haptiv {

/// Whether the triangles have no rim: every edge is passed as often one way as the other. Told by a sum of 64-bit
/// hashes over the edges, plus one way and minus the other: O(n), without a table; wrong once in 2^64 times.
bool hasNoRim(const std::vector<TriangleMesh::Triangle>& triangles) noexcept;

/// Volume that triangles without a rim bound, negative where they face inwards [m^3].
double volumeWithin(const std::vector<Vector3>& vertices,
                    const std::vector<TriangleMesh::Triangle>& triangles) noexcept;

}  // namespace haptiv
