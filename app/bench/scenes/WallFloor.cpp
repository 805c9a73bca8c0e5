#include "app/bench/scenes/WallFloor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/bench/scenes/Dice.h"
#include "haptics/shapes/ShapeDistance.h"

namespace haptiv {
namespace {

constexpr std::uint32_t kRidgeEvery = 8;
constexpr double kFloorTick = 1e-3;  // [s] a tick

/// 0 to 1 with no jerk at the ends.
double smooth(double t) {
  return 0.5 - 0.5 * std::cos(std::numbers::pi * t);
}

/// Appends straight ways, as a hand would go them.
class PathWriter {
 public:
  PathWriter(std::vector<ToolMotion>& path, double radius) : path_(path), radius_(radius) {}

  void go(const Vector3& to, int ticks, double ripple = 0) {
    const Vector3 from = path_.empty() ? to : place_;
    for (int i = 1; i <= ticks; ++i) {
      const double t = static_cast<double>(i) / ticks;
      const Vector3 wave(0, 0, ripple * std::sin(12 * std::numbers::pi * t));
      const Vector3 next = from + smooth(t) * (to - from) + wave;
      path_.push_back({next, path_.empty() ? Vector3(0, 0, 0) : Vector3((next - last_) / kFloorTick), radius_});
      last_ = next;
    }
    place_ = to;
  }

 private:
  std::vector<ToolMotion>& path_;
  double radius_;
  Vector3 place_ = Vector3::Zero(), last_ = Vector3::Zero();
};

}  // namespace

WallFloor::WallFloor(std::uint32_t walls, double scale)
    : perRow_(static_cast<std::uint32_t>(std::sqrt(static_cast<double>(walls)))), rows_(walls / perRow_) {
  Dice dice;
  scene_.version = 1;
  scene_.tool.radius = 0.01 * scale;
  scene_.walls.resize(walls);
  const double half = tile() / 2;
  for (std::uint32_t i = 0; i < walls; ++i) {
    const std::uint32_t row = i / perRow_;
    const double top = radius() * (row % kRidgeEvery == 0 ? 5 : 0.1 * dice());
    Wall& wall = scene_.walls[i];
    wall.id = i + 1;
    wall.surface.stiffness = 1000 + 2000 * dice();
    wall.surface.damping = 10 + 20 * dice();
    wall.shape.centre = {(2 * (i % perRow_) + 1) * half, (2 * row + 1) * half, (top - tile()) / 2};
    wall.shape.axes = Vector3(half, half, (top + tile()) / 2).asDiagonal();
  }
  computeBounds(scene_);
}

bool WallFloor::isTouching(const Vector3& p_W) const {
  const auto column = static_cast<std::int64_t>(std::floor(p_W.x() / tile()));
  const auto row = static_cast<std::int64_t>(std::floor(p_W.y() / tile()));
  for (std::int64_t y = row - 1; y <= row + 1; ++y) {
    for (std::int64_t x = column - 1; x <= column + 1; ++x) {
      const std::int64_t wall = y * perRow_ + x;
      if (x < 0 || y < 0 || x >= perRow_ || wall >= static_cast<std::int64_t>(scene_.walls.size())) continue;
      const SurfacePoint surface = nearestSurface(scene_.walls[static_cast<std::size_t>(wall)].shape, p_W);
      if (surface.distance < radius() * (1 - 1e-9)) return true;
    }
  }
  return false;
}

std::vector<ToolMotion> pathOver(const WallFloor& floor, int legs) {
  Dice dice;
  const double r = floor.radius();
  const double tile = floor.tile();
  std::vector<ToolMotion> path;
  PathWriter writer(path, r);
  const double length = 5 * tile;  // of a slide
  for (int leg = 0; leg < legs; ++leg) {
    const std::uint32_t ridge =
        kRidgeEvery * static_cast<std::uint32_t>(dice() * ((floor.rows() - 2) / kRidgeEvery + 1));
    const double beside = leg % 2 == 0 ? 0.97 * r : 1.5 * tile;  // of the ridge: touching it, or not
    const double x = tile + dice() * (floor.rows() * tile - 2 * tile - length);
    const double y = (ridge + 1) * tile + beside;
    const double touching = 1.1 * r;
    writer.go({x, y, 6.5 * r}, 200);
    writer.go({x, y, touching}, 100);
    writer.go({x, y, touching - 0.2 * r}, 100);
    writer.go({x + length, y, touching - 0.2 * r}, 400, 0.05 * r);
    writer.go({x + length, y, 6.5 * r}, 100);
  }
  return path;
}

}  // namespace haptiv
