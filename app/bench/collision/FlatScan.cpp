#include "app/bench/collision/FlatScan.h"

#include "haptics/shapes/ShapeDistance.h"

namespace haptiv {

FlatScan::FlatScan(const HapticScene& scene) : scene_(scene) {
  for (const Wall& wall : scene.walls) bounds_.push_back(boundsOf(wall.shape));
}

Vector3 FlatScan::force(const ToolMotion& tool) const noexcept {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < bounds_.size(); ++i) {
    const Bounds& box = bounds_[i];
    if (((tool.position - box.low).array() < -tool.radius).any()) continue;
    if (((tool.position - box.high).array() > tool.radius).any()) continue;
    const Wall& wall = scene_.walls[i];
    const SurfacePoint surface = nearestSurface(wall.shape, tool.position);
    if (surface.distance >= tool.radius) continue;
    sum += wall.surface.stiffness * (tool.radius - surface.distance) * surface.normal;
  }
  return sum;
}

}  // namespace haptiv
