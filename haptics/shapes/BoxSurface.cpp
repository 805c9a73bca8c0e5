#include "haptics/shapes/BoxSurface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptics/geometry/UnitVector.h"
#include "haptics/shapes/StraightBoxSurface.h"

namespace haptiv {
namespace {

/// A point against the three pairs of planes of a box.
struct BoxPlanes {
  BoxPlanes(const Shape& shape, const Vector3& p_W) : d(p_W - shape.centre) {
    for (int i = 0; i < 3; ++i) {
      const Vector3 a = shape.axes.col(i);
      const Vector3 cross = shape.axes.col((i + 1) % 3).cross(shape.axes.col((i + 2) % 3));
      normal.col(i) = unitOr(a.dot(cross) < 0 ? Vector3(-cross) : cross, unitOr(a, Vector3::UnitZ()));
      half[i] = std::abs(a.dot(normal.col(i)));
      along[i] = d.dot(normal.col(i));
    }
    const Vector3 lengths = shape.axes.colwise().norm().transpose();
    hasVolume = std::abs(shape.axes.determinant()) > 1e-12 * lengths.prod();
    size = lengths.maxCoeff();
  }

  double gap(int i) const noexcept { return std::abs(along[i]) - half[i]; }

  Vector3 d;       ///< from the centre to the point
  Matrix3 normal;  ///< unit normals of the faces at +a_i, as columns
  Vector3 half;    ///< distance of those faces' planes from the centre
  Vector3 along;   ///< of the point, on the normals
  bool hasVolume;
  double size;
};

double clampedRatio(double numerator, double denominator) noexcept {
  return denominator > 0 ? std::clamp(numerator / denominator, -1.0, 1.0) : 0;
}

/// Shortest vector from the parallelogram {u a + v b : |u|, |v| <= 1} to r, exact; `within`: its foot is not on the
/// rim.
struct FromParallelogram {
  FromParallelogram(const Vector3& r, const Vector3& a, const Vector3& b) {
    const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b), ra = r.dot(a), rb = r.dot(b);
    const double det = aa * bb - ab * ab;
    if (det > 1e-14 * aa * bb) {
      const double u = (ra * bb - rb * ab) / det;
      const double v = (rb * aa - ra * ab) / det;
      within = std::abs(u) <= 1 && std::abs(v) <= 1;
      if (within) vector = r - u * a - v * b;
    }
    if (!within) toRim(r, a, b, {aa, bb, ab, ra, rb});
  }

  Vector3 vector = Vector3::Zero();
  bool within = false;

 private:
  void toRim(const Vector3& r, const Vector3& a, const Vector3& b, const std::array<double, 5>& dots) {
    const auto& [aa, bb, ab, ra, rb] = dots;
    double best = std::numeric_limits<double>::infinity();
    for (const double side : {-1.0, 1.0}) {
      for (const Vector3& v : {Vector3(r - clampedRatio(ra - side * ab, aa) * a - side * b),
                               Vector3(r - side * a - clampedRatio(rb - side * ab, bb) * b)}) {
        if (v.squaredNorm() < best) {
          best = v.squaredNorm();
          vector = v;
        }
      }
    }
  }
};

SurfacePoint inside(const BoxPlanes& planes) noexcept {
  int nearest = 0;
  for (int i = 1; i < 3; ++i) {
    if (planes.gap(i) > planes.gap(nearest)) nearest = i;
  }
  const double side = planes.along[nearest] < 0 ? -1 : 1;
  return {planes.gap(nearest), side * planes.normal.col(nearest), 2 * nearest + (side < 0 ? 1 : 0)};
}

/// Takes the face at side * axes.col(i) into `best` if it is nearer.
void tryFace(const Shape& shape, const BoxPlanes& planes, int i, double side, SurfacePoint& best) noexcept {
  const FromParallelogram from(planes.d - side * shape.axes.col(i), shape.axes.col((i + 1) % 3),
                               shape.axes.col((i + 2) % 3));
  const double distance = from.vector.norm();
  if (!(distance < best.distance * (1 - 1e-12))) return;
  const bool onFace = from.within && planes.hasVolume;
  const bool tooShort = !(distance > 1e-12 * planes.size);
  best.distance = onFace ? planes.gap(i) : distance;
  best.normal = onFace || tooShort ? Vector3(side * planes.normal.col(i)) : Vector3(from.vector / distance);
  best.face = 2 * i + (side < 0 ? 1 : 0);
}

/// The nearest point of a convex body lies on a face whose plane the point is beyond: at most three of them.
SurfacePoint outside(const Shape& shape, const BoxPlanes& planes) noexcept {
  std::array<int, 3> order{0, 1, 2};  // by falling gap, so that of equal faces the one most faced is named
  if (planes.gap(order[1]) > planes.gap(order[0])) std::swap(order[0], order[1]);
  if (planes.gap(order[2]) > planes.gap(order[1])) std::swap(order[1], order[2]);
  if (planes.gap(order[1]) > planes.gap(order[0])) std::swap(order[0], order[1]);
  SurfacePoint best{std::numeric_limits<double>::infinity(), Vector3::UnitZ(), 0};
  for (const int i : order) {
    if (planes.gap(i) > 0) tryFace(shape, planes, i, planes.along[i] < 0 ? -1 : 1, best);
  }
  return best;
}

/// A box without volume is the union of its faces.
SurfacePoint onFlat(const Shape& shape, const BoxPlanes& planes) noexcept {
  SurfacePoint best{std::numeric_limits<double>::infinity(), Vector3::UnitZ(), 0};
  for (int i = 0; i < 3; ++i) {
    const double side = planes.along[i] < 0 ? -1 : 1;
    tryFace(shape, planes, i, side, best);
    tryFace(shape, planes, i, -side, best);
  }
  return best;
}

}  // namespace

SurfacePoint onBoxFace(const Shape& shape, const Vector3& p_W, int face) noexcept {
  const BoxPlanes planes(shape, p_W);
  const int i = std::clamp(face / 2, 0, 2);
  const double side = face % 2 == 0 ? 1 : -1;
  return {side * planes.along[i] - planes.half[i], side * planes.normal.col(i), face};
}

SurfacePoint nearestOnBox(const Shape& shape, const Vector3& p_W) noexcept {
  if (const auto box = straightBox(shape)) return nearestOnStraightBox(*box, BesideBox(*box, p_W));
  const BoxPlanes planes(shape, p_W);
  if (!planes.hasVolume) return onFlat(shape, planes);
  const bool isInside = planes.gap(0) <= 0 && planes.gap(1) <= 0 && planes.gap(2) <= 0;
  return isInside ? inside(planes) : outside(shape, planes);
}

}  // namespace haptiv
