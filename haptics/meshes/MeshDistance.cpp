#include "haptics/meshes/MeshDistance.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "haptics/geometry/UnitVector.h"
#include "haptics/meshes/TrianglePoint.h"

namespace haptiv {
namespace {

constexpr double kFar = std::numeric_limits<double>::max();

Vector3 closestOn(const TriangleMesh& mesh, std::size_t triangle, const Vector3& p) noexcept {
  return closestOnTriangle(p, mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2));
}

/// Angle under which a triangle is seen from a point of it: 2 pi within, pi on an edge, the corner's in a corner.
double angleAt(const TriangleMesh& mesh, std::size_t triangle, const Vector3& at, double tolerance) noexcept {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 to = mesh.corner(triangle, i) - at, next = mesh.corner(triangle, (i + 1) % 3) - at;
    if (to.squaredNorm() <= tolerance * tolerance || next.squaredNorm() <= tolerance * tolerance) continue;
    sum += std::atan2(to.cross(next).norm(), to.dot(next));
  }
  return sum;
}

/// Sum over the triangles that meet in a point of the mesh.
Vector3 angleWeightedNormal(const TriangleMesh& mesh, const Vector3& at, double tolerance) noexcept {
  Vector3 sum = Vector3::Zero();
  const auto add = [&](std::size_t triangle) {
    if ((closestOn(mesh, triangle, at) - at).squaredNorm() > tolerance * tolerance) return;
    sum += angleAt(mesh, triangle, at, tolerance) * faceNormal(mesh, triangle);
  };
  mesh.tree.forEachNear(at, tolerance, [&](std::size_t block) { mesh.forEachOf(block, add); });
  return sum;
}

}  // namespace

Vector3 faceNormal(const TriangleMesh& mesh, std::size_t triangle) noexcept {
  const Vector3& a = mesh.corner(triangle, 0);
  const Vector3 ab = mesh.corner(triangle, 1) - a, ac = mesh.corner(triangle, 2) - a;
  return unitOr(ab.cross(ac), unitOr(ab, Vector3::UnitX()).unitOrthogonal());
}

SurfacePoint nearestOnMesh(const TriangleMesh& mesh, const Vector3& p_W) noexcept {
  std::size_t nearest = mesh.triangles.size();
  Vector3 at = Vector3::Zero();
  double best = kFar;
  const auto measure = [&](std::size_t triangle) {
    const Vector3 closest = closestOn(mesh, triangle, p_W);
    const double distance = (closest - p_W).norm();
    if (!(distance < best || (distance == best && triangle < nearest))) return;
    best = distance;
    nearest = triangle;
    at = closest;
  };
  mesh.tree.nearest(p_W, std::sqrt(kFar), [&](std::size_t block) {
    mesh.forEachOf(block, measure);
    return best;
  });
  if (nearest == mesh.triangles.size()) return {kFar, Vector3::UnitZ(), 0};
  const int face = static_cast<int>(nearest);
  const double size = (mesh.bounds.high - mesh.bounds.low).norm() + at.cwiseAbs().maxCoeff();
  const double rounding = 1e-12 * size;
  const Vector3 away = p_W - at;
  const Vector3 outward = mesh.closed ? angleWeightedNormal(mesh, at, rounding) : Vector3::Zero();
  if (!(best > rounding)) return {best, unitOr(outward, faceNormal(mesh, nearest)), face};
  if (mesh.closed && away.dot(outward) < 0) return {-best, -away / best, face};
  return {best, away / best, face};
}

SurfacePoint onMeshFace(const TriangleMesh& mesh, const Vector3& p_W, int face) noexcept {
  const auto triangle = static_cast<std::size_t>(face);
  if (face < 0 || triangle >= mesh.triangles.size()) return {kFar, Vector3::UnitZ(), 0};
  const Vector3 away = p_W - closestOn(mesh, triangle, p_W);
  return {away.norm(), unitOr(away, faceNormal(mesh, triangle)), face};
}

}  // namespace haptiv
