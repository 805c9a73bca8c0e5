#include "app/bench/scenes/MeshSphere.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "app/bench/scenes/Dice.h"

namespace haptiv {
namespace {

constexpr double kTick = 1e-3;  // [s] a tick

Vector3 direction(Dice& dice) {
  const double z = 2 * dice() - 1, angle = 2 * std::numbers::pi * dice();
  return {std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z};
}

/// A square of the cube around the sphere, n x n cells, blown up to it.
void addSide(const Matrix3& turned, std::uint32_t n, double radius, std::vector<Vector3>& vertices,
             std::vector<TriangleMesh::Triangle>& triangles) {
  const auto first = static_cast<std::uint32_t>(vertices.size());
  const auto across = [n](std::uint32_t i) { return std::tan(std::numbers::pi / 4 * (2.0 * i / n - 1)); };
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t j = 0; j <= n; ++j) {
      vertices.push_back(radius * (turned * Vector3(across(i), across(j), 1)).normalized());
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = first + i * (n + 1) + j, b = a + n + 1;
      triangles.push_back({a, b, b + 1});
      triangles.push_back({a, b + 1, a + 1});
    }
  }
}

}  // namespace

HapticScene meshSphere(std::uint32_t triangles, double scale) {
  const double radius = scale * kSphereRadius;
  const auto n = static_cast<std::uint32_t>(std::ceil(std::sqrt(triangles / 12.0)));
  std::vector<Vector3> vertices;
  std::vector<TriangleMesh::Triangle> corners;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Eigen::AngleAxisd turn(quarter * std::numbers::pi / 2, Vector3::UnitX());
    addSide(turn.toRotationMatrix(), n, radius, vertices, corners);
  }
  for (const double side : {1.0, -1.0}) {
    const Eigen::AngleAxisd turn(side * std::numbers::pi / 2, Vector3::UnitY());
    addSide(turn.toRotationMatrix(), n, radius, vertices, corners);
  }
  HapticScene scene;
  scene.version = 1;
  scene.tool.radius = scale * kSphereToolRadius;
  Wall& wall = scene.walls.emplace_back();
  wall.id = 1;
  wall.shape.kind = Shape::Kind::mesh;
  wall.shape.axes = radius * Matrix3::Identity();
  wall.shape.mesh = makeTriangleMesh(vertices, corners);
  computeBounds(scene);
  return scene;
}

std::vector<ToolMotion> pathOverSphere(int legs, double scale) {
  Dice dice;
  std::vector<ToolMotion> path;
  const double radius = scale * kSphereRadius, ball = scale * kSphereToolRadius;
  const double high = radius + 3 * ball, deep = radius + 0.5 * ball;
  Vector3 from = Vector3::UnitZ();
  const auto go = [&](const Vector3& axis, double turn, double start, double end, int ticks) {
    for (int i = 1; i <= ticks; ++i) {
      const double t = static_cast<double>(i) / ticks;
      const Vector3 place = (start + t * (end - start)) * (Eigen::AngleAxisd(t * turn, axis) * from);
      const Vector3 velocity = path.empty() ? Vector3(0, 0, 0) : Vector3((place - path.back().position) / kTick);
      path.push_back({place, velocity, ball});
    }
    from = Eigen::AngleAxisd(turn, axis) * from;
  };
  const auto anyAxis = [&] { return from.cross(direction(dice)).normalized(); };
  for (int leg = 0; leg < legs; ++leg) {
    go(anyAxis(), 2, high, high, 300);
    go(anyAxis(), 0, high, deep, 100);
    go(anyAxis(), std::numbers::pi / 2, deep, deep, 800);
    go(anyAxis(), 0, deep, high, 100);
  }
  return path;
}

}  // namespace haptiv
