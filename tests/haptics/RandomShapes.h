#pragma once

#include <Eigen/Geometry>
#include <random>
#include <utility>
#include <vector>

#include "haptics/scene/HapticScene.h"

namespace haptiv::testing {

inline const Vector3 kRest = Vector3::Zero();  ///< the velocity of a ball at rest [m/s]

/// Seeded random input; the same seed gives the same run.
class RandomShapes {
 public:
  explicit RandomShapes(unsigned seed) : engine_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  Vector3 vector(double reach) { return {between(-reach, reach), between(-reach, reach), between(-reach, reach)}; }
  Vector3 direction() {
    Vector3 v = vector(1);
    while (!(v.norm() > 0.1 && v.norm() <= 1)) v = vector(1);
    return v.normalized();
  }
  Matrix3 rotation() { return Eigen::AngleAxisd(between(0, 3), direction()).toRotationMatrix(); }

  /// A shape of about `size`, thin ones among them.
  Shape shape(Shape::Kind kind, double size = 1) {
    Shape shape;
    shape.kind = kind;
    shape.centre = vector(size);
    const double a = size * between(0.05, 1);
    const double b = size * between(0.05, 1);
    const double c = kind == Shape::Kind::box ? size * between(0.05, 1) : a;
    shape.axes = rotation() * Vector3(a, kind == Shape::Kind::sphere ? a : b, c).asDiagonal();
    return shape;
  }
  Shape skewedBox() {
    Shape shape;
    shape.centre = vector(1);
    do {
      for (int i = 0; i < 3; ++i) shape.axes.col(i) = between(0.1, 1) * direction();
    } while (std::abs(shape.axes.determinant()) < 0.02);
    return shape;
  }
  /// A point of the shape's surface, anywhere on it.
  Vector3 onSurface(const Shape& shape) {
    const double angle = between(0, 6.2831853071795865);
    Vector3 s = vector(1);
    switch (shape.kind) {
      case Shape::Kind::mesh:  // of these there are none: shape() makes exact ones
      case Shape::Kind::box:
        s[static_cast<int>(between(0, 2.999))] = between(-1, 1) < 0 ? -1 : 1;
        break;
      case Shape::Kind::sphere:
        s = direction();
        break;
      case Shape::Kind::cylinder: {
        const bool side = between(0, 1) < 0.5;
        const double r = side ? 1 : std::sqrt(between(0, 1));
        s = {r * std::cos(angle), side ? s.y() : (s.y() < 0 ? -1 : 1), r * std::sin(angle)};
        break;
      }
      case Shape::Kind::cone: {
        const bool side = between(0, 1) < 0.5;
        const double r = side ? (1 - s.y()) / 2 : std::sqrt(between(0, 1));
        s = {r * std::cos(angle), side ? s.y() : -1, r * std::sin(angle)};
        break;
      }
    }
    return shape.centre + shape.axes * s;
  }

 private:
  std::mt19937 engine_;
};

/// Zero on the surface, negative inside, positive outside, in units of the half extents.
inline double implicitValue(const Shape& shape, const Vector3& p_W) {
  const Vector3 s = shape.axes.inverse() * (p_W - shape.centre);
  const double radial = std::hypot(s.x(), s.z());
  switch (shape.kind) {
    case Shape::Kind::sphere:
      return s.norm() - 1;
    case Shape::Kind::cylinder:
      return std::max(radial - 1, std::abs(s.y()) - 1);
    case Shape::Kind::cone:
      return std::max(radial - (1 - s.y()) / 2, -1 - s.y());
    case Shape::Kind::mesh:
    case Shape::Kind::box:
      break;
  }
  return s.cwiseAbs().maxCoeff() - 1;
}

/// A wall of a given thickness: its front face is the plane z = 0, and it reaches far along x and y.
inline Wall wallBelow(double thickness, double stiffness = 2000, double damping = 20) {
  Wall wall;
  wall.id = 1;
  wall.shape.centre = {0, 0, -thickness / 2};
  wall.shape.axes = Vector3(2, 2, thickness / 2).asDiagonal();
  wall.surface.stiffness = stiffness;
  wall.surface.damping = damping;
  return wall;
}

/// A scene of these walls, which get the ids 1, 2, ...
inline HapticScene sceneOf(std::vector<Wall> walls) {
  HapticScene scene;
  scene.version = 1;
  scene.walls = std::move(walls);
  for (std::size_t i = 0; i < scene.walls.size(); ++i) scene.walls[i].id = static_cast<ShapeId>(i + 1);
  computeBounds(scene);
  return scene;
}

/// The same scene turned and moved.
inline HapticScene moved(HapticScene scene, const Matrix3& R, const Vector3& p) {
  const auto move = [&](Shape& shape) {
    shape.centre = R * shape.centre + p;
    shape.axes = R * shape.axes;
  };
  for (Wall& wall : scene.walls) move(wall.shape);
  for (Zone& zone : scene.zones) {
    move(zone.shape);
    zone.anchor = R * zone.anchor + p;
  }
  computeBounds(scene);
  return scene;
}

}  // namespace haptiv::testing
