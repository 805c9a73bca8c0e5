#pragma once

#include <cstdint>
#include <vector>

#include "haptics/laws/IfThenRenderer.h"
#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// A floor of box walls, each with its own properties, in a square grid. Tops differ a little; every eighth row is a
/// ridge, as high as five radii of the ball.
///
/// For any place it is known without a search which walls can be near: what a renderer misses can be counted.
class WallFloor {
 public:
  /// @param scale  1: a ball of 10 mm on tiles of 30 mm
  WallFloor(std::uint32_t walls, double scale);

  const HapticScene& scene() const { return scene_; }
  double radius() const { return scene_.tool.radius; }
  double tile() const { return 3 * radius(); }
  std::uint32_t rows() const { return rows_; }  ///< which are there from end to end; so many walls are in each
  /// Whether the ball overlaps a wall, by more than rounding.
  bool isTouching(const Vector3& p_W) const;

 private:
  HapticScene scene_;
  std::uint32_t perRow_;
  std::uint32_t rows_;
};

/// A path over the floor, tick by tick: it travels far, descends next to a ridge or between two, presses, slides over
/// five tiles, and lifts; again and again, elsewhere.
std::vector<ToolMotion> pathOver(const WallFloor& floor, int legs);

}  // namespace haptiv
