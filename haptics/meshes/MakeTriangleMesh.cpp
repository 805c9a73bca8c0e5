#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/meshes/OrderTriangles.h"
#include "haptics/meshes/Orientation.h"
#include "haptics/meshes/TriangleMesh.h"
#include "haptics/meshes/WeldVertices.h"

namespace haptiv {
namespace {

using Triangle = TriangleMesh::Triangle;

constexpr double kOfSize = 1e-6;       ///< what is nearer than this part of the mesh is one spot
constexpr double kOfNumbers = 2.4e-7;  ///< two steps of single precision, which files are written in

std::vector<Triangle> soundOnes(const std::vector<Vector3>& vertices, const std::vector<Triangle>& triangles) {
  const auto isSound = [&](std::uint32_t corner) {
    return corner < vertices.size() && vertices[corner].cwiseAbs().maxCoeff() < TriangleMesh::kFar &&
           vertices[corner].allFinite();
  };
  std::vector<Triangle> sound;
  sound.reserve(triangles.size());
  std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(sound),
               [&](const Triangle& triangle) { return std::all_of(triangle.begin(), triangle.end(), isSound); });
  return sound;
}

Bounds around(const std::vector<Vector3>& vertices, const Triangle& triangle) {
  const Vector3 &a = vertices[triangle[0]], &b = vertices[triangle[1]], &c = vertices[triangle[2]];
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

Bounds around(const std::vector<Bounds>& boxes) {
  Bounds all = boxes.front();
  for (const Bounds& box : boxes) all = {all.low.cwiseMin(box.low), all.high.cwiseMax(box.high)};
  return all;
}

std::vector<Bounds> boxesOf(const std::vector<Vector3>& vertices, const std::vector<Triangle>& triangles) {
  std::vector<Bounds> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& triangle : triangles) boxes.push_back(around(vertices, triangle));
  return boxes;
}

double weldingTolerance(const Bounds& all) {
  const double numbers = std::max(all.low.cwiseAbs().maxCoeff(), all.high.cwiseAbs().maxCoeff());
  return std::max(kOfSize * (all.high - all.low).norm(), kOfNumbers * numbers);
}

}  // namespace

std::shared_ptr<const TriangleMesh> makeTriangleMesh(const std::vector<Vector3>& vertices,
                                                     const std::vector<Triangle>& triangles) {
  std::vector<Triangle> kept = soundOnes(vertices, triangles);
  if (kept.empty()) return nullptr;
  std::vector<Vector3> welded = vertices;
  weldVertices(welded, kept, weldingTolerance(around(boxesOf(vertices, kept))));
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
  const std::vector<Bounds> boxes = boxesOf(vertices, triangles);
  mesh->bounds = around(boxes);
  mesh->tree = BoundingTree(boxesOfBlocks(boxes));
  mesh->blocks = makeBlocks(vertices, triangles);
  const double size = (mesh->bounds.high - mesh->bounds.low).norm();
  mesh->closed = hasNoRim(triangles) && volumeWithin(vertices, triangles) > 1e-12 * size * size * size;
  mesh->vertices = std::move(vertices);
  mesh->triangles = std::move(triangles);
  return mesh;
}

}  // namespace haptiv
