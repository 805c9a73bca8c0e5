#pragma once

#include <vector>

#include "haptics/laws/IfThenRenderer.h"
#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// The peer of the collision bench: looks at every wall's box in turn, and lets the near ones push the ball by their
/// depth. It remembers nothing, and works for any scene; what it costs grows with the number of walls.
class FlatScan {
 public:
  explicit FlatScan(const HapticScene& scene);
  Vector3 force(const ToolMotion& tool) const noexcept;

 private:
  const HapticScene& scene_;
  std::vector<Bounds> bounds_;
};

}  // namespace haptiv
