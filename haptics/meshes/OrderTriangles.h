#pragma once

#include <vector>

#include "haptics/meshes/TriangleMesh.h"

namespace haptiv {

/// Brings triangles that are near each other in space near each other in memory (Morton's order of their middles), then
/// the vertices into the order in which the triangles name them; vertices of no triangle are dropped.
void orderTriangles(std::vector<Vector3>& vertices, std::vector<TriangleMesh::Triangle>& triangles);

}  // namespace haptiv
