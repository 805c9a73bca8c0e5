#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "haptics/scene/HapticScene.h"

namespace haptiv::testing {

/// Triangles as a file has them: three corners each, not shared.
struct Soup {
  std::vector<Vector3> vertices;
  std::vector<TriangleMesh::Triangle> triangles;

  void add(const Vector3& a, const Vector3& b, const Vector3& c) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), {a, b, c});
    triangles.push_back({first, first + 1, first + 2});
  }
  /// Corners counter-clockwise, seen from outside.
  void addQuad(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
    add(a, b, c);
    add(a, c, d);
  }
  std::shared_ptr<const TriangleMesh> mesh() const { return makeTriangleMesh(vertices, triangles); }
};

/// The box |s_i| <= 1 under s -> centre + axes s, each face of n x n pairs of triangles.
inline Soup boxSoup(const Vector3& centre, const Matrix3& axes, int n = 1) {
  Soup soup;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const auto at = [&](int i, int j) {
        Vector3 s;
        s[axis] = side;
        s[(axis + 1) % 3] = side * (2.0 * i / n - 1);  // the other way round on the far side: the face is turned
        s[(axis + 2) % 3] = 2.0 * j / n - 1;
        return Vector3(centre + axes * s);
      };
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) soup.addQuad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  return soup;
}

/// A sphere around the origin, of 2 n meridians and n parallels.
inline Soup sphereSoup(double radius, int n) {
  Soup soup;
  const auto at = [&](int i, int j) {
    const double polar = M_PI * j / n, around = M_PI * (i % (2 * n)) / n;
    if (j == 0 || j == n) return Vector3(0, 0, j == 0 ? radius : -radius);
    return Vector3(radius * std::sin(polar) * Vector3(std::cos(around), std::sin(around), 0) +
                   radius * std::cos(polar) * Vector3::UnitZ());
  };
  for (int i = 0; i < 2 * n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (j > 0) soup.add(at(i, j), at(i, j + 1), at(i + 1, j));
      if (j < n - 1) soup.add(at(i + 1, j), at(i, j + 1), at(i + 1, j + 1));
    }
  }
  return soup;
}

/// The rectangle |x|, |y| <= half in the plane z = 0, facing up, of n x n pairs of triangles.
inline Soup plateSoup(double half, int n = 1) {
  Soup soup;
  const auto at = [&](int i, int j) { return Vector3(half * (2.0 * i / n - 1), half * (2.0 * j / n - 1), 0); };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) soup.addQuad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }
  return soup;
}

inline Wall meshWall(const Soup& soup, double stiffness = 2000, double damping = 20) {
  Wall wall;
  wall.shape.kind = Shape::Kind::mesh;
  wall.shape.mesh = soup.mesh();
  wall.surface.stiffness = stiffness;
  wall.surface.damping = damping;
  return wall;
}

/// The triangles turned and moved.
inline Soup moved(Soup soup, const Matrix3& R, const Vector3& p) {
  for (Vector3& vertex : soup.vertices) vertex = R * vertex + p;
  return soup;
}

}  // namespace haptiv::testing
