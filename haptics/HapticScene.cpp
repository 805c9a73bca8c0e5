#include "haptics/HapticScene.h"

#include "haptics/ShapeDistance.h"

namespace haptiv {

void computeBounds(HapticScene& scene) {
  scene.wallBounds.clear();
  scene.zoneBounds.clear();
  for (const Wall& wall : scene.walls) scene.wallBounds.push_back(boundsOf(wall.shape));
  for (const Zone& zone : scene.zones) scene.zoneBounds.push_back(boundsOf(zone.shape));
}

}  // namespace haptiv
