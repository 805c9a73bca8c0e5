#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "device/types.h"

namespace haptiv {

/// A surface of triangles, in W. Immutable once it stands in a scene.
struct TriangleMesh {
  using Triangle = std::array<std::uint32_t, 3>;  ///< indices into `vertices`, counter-clockwise seen from outside

  std::vector<Vector3> vertices;  ///< [m]; corners on one spot are one vertex
  std::vector<Triangle> triangles;
};

}  // namespace haptiv
