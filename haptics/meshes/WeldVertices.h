#pragma once

#include <vector>

#include "haptics/meshes/TriangleMesh.h"

namespace haptiv {

/// Makes one vertex of corners that are nearer to each other than `tolerance` [m] along every axis, and drops
/// triangles of which two corners are one. A vertex stays where its first corner was.
/// Indices must be in range, corners finite, none beyond 1e6 tolerances or so. O(n).
void weldVertices(std::vector<Vector3>& vertices, std::vector<TriangleMesh::Triangle>& triangles, double tolerance);

}  // namespace haptiv
