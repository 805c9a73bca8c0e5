#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/TriangleMesh.h"
#include "haptics/meshes/OrderTriangles.h"
#include "haptics/meshes/Orientation.h"
#include "haptics/meshes/WeldVertices.h"

namespace haptiv {
namespace {

using Triangle = TriangleMesh::Triangle;

/// Beyond it, squares and cubes of lengths overflow.
constexpr double kFar = 1e100;
constexpr double kOfSize = 1e-6;       ///< what is nearer than this part of the mesh is one spot
constexpr double kOfNumbers = 2.4e-7;  ///< two steps of single precision, which files are written in

std::vector<Triangle> soundOnes(const std::vector<Vector3>& vertices, const std::vector<Triangle>& triangles) {
  const auto isSound = [&](std::uint32_t corner) {
    return corner < vertices.size() && vertices[corner].cwiseAbs().maxCoeff() < kFar && vertices[corner].allFinite();
  };
  std::vector<Triangle> sound;
  sound.reserve(triangles.size());
  std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(sound),
               [&](const Triangle& triangle) { return std::all_of(triangle.begin(), triangle.end(), isSound); });
  return sound;
}

/// Box around the corners.
std::pair<Vector3, Vector3> extent(const std::vector<Vector3>& vertices, const std::vector<Triangle>& triangles) {
  Vector3 low = vertices[triangles.front()[0]], high = low;
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t corner : triangle) {
      low = low.cwiseMin(vertices[corner]);
      high = high.cwiseMax(vertices[corner]);
    }
  }
  return {low, high};
}

double weldingTolerance(const Vector3& low, const Vector3& high) {
  return std::max(kOfSize * (high - low).norm(),
                  kOfNumbers * std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff()));
}

}  // namespace

std::shared_ptr<const TriangleMesh> makeTriangleMesh(const std::vector<Vector3>& vertices,
                                                     const std::vector<Triangle>& triangles) {
  std::vector<Triangle> kept = soundOnes(vertices, triangles);
  if (kept.empty()) return nullptr;
  const auto [low, high] = extent(vertices, kept);
  std::vector<Vector3> welded = vertices;
  weldVertices(welded, kept, weldingTolerance(low, high));
  orderTriangles(welded, kept);
  if (kept.empty()) return nullptr;
  if (hasNoRim(kept) && volumeWithin(welded, kept) < 0) {
    for (Triangle& triangle : kept) std::swap(triangle[1], triangle[2]);
  }
  return restoreTriangleMesh(std::move(welded), std::move(kept));
}

std::shared_ptr<const TriangleMesh> restoreTriangleMesh(std::vector<Vector3> vertices,
                                                        std::vector<Triangle> triangles) {
  if (triangles.empty()) return nullptr;
  auto mesh = std::make_shared<TriangleMesh>();
  const auto [low, high] = extent(vertices, triangles);
  const double size = (high - low).norm();
  mesh->closed = hasNoRim(triangles) && volumeWithin(vertices, triangles) > 1e-12 * size * size * size;
  mesh->vertices = std::move(vertices);
  mesh->triangles = std::move(triangles);
  return mesh;
}

}  // namespace haptiv
