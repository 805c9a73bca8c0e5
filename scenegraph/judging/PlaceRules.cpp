#include <Inventor/fields/SoSFString.h>
#include <Inventor/nodes/SoNode.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <unordered_map>

#include "haptics/scene/NearShapes.h"
#include "haptics/servo/SessionStart.h"
#include "scenegraph/Keyword.h"
#include "scenegraph/NumberText.h"
#include "scenegraph/judging/Findings.h"
#include "scenegraph/judging/ReachOfArm.h"
#include "scenegraph/judging/Rules.h"

namespace haptiv {
namespace {

/// Whether the box around the zone is inside the wall. Walls of an exact kind are convex: their corners tell.
bool isWithin(const Shape& zone, const Shape& wall) {
  if (wall.kind == Shape::Kind::mesh) return false;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 s(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    if (nearestSurface(wall, zone.centre + zone.axes * s).distance > 0) return false;
  }
  return true;
}

bool isBuried(const Zone& zone, const HapticScene& scene) {
  bool buried = false;
  forEachNear(scene.walls, scene.wallIndex, zone.shape.centre, 0, [&](std::size_t wall, const SurfacePoint&) {
    buried = buried || isWithin(zone.shape, scene.walls[wall].shape);
  });
  return buried;
}

Eigen::AlignedBox3d boundsOfFelt(const HapticScene& scene) {
  Eigen::AlignedBox3d box;
  const auto extend = [&](const Shape& shape) {
    const Bounds bounds = boundsOf(shape);
    box.extend(bounds.low);
    box.extend(bounds.high);
  };
  for (const Wall& wall : scene.walls) extend(wall.shape);
  for (const Zone& zone : scene.zones) extend(zone.shape);
  return box;
}

/// The node, or the first of what is felt: something on a line of the file.
const SoNode* somewhere(const SceneOrigins& origins) {
  if (origins.device) return origins.device;
  if (!origins.walls.empty()) return origins.walls.front().shape;
  return origins.zones.empty() ? origins.tool : origins.zones.front().shape;
}

}  // namespace

Diagnostics judgeReachOfHome(const JudgedScene& judged) {
  Findings found;
  if (!sessionStart(judged.scene, judged.device).inReach()) {
    found.error(judged.origins.tool,
                "home is out of the arm's reach; move it, or the HapticDevice, or raise the device's scale");
  }
  return std::move(found).take();
}

Diagnostics judgeHomeInWall(const JudgedScene& judged) {
  const HapticScene& scene = judged.scene;
  Findings found;
  const SoNode* around = nullptr;
  forEachNear(scene.walls, scene.wallIndex, scene.tool.home, scene.tool.radius,
              [&](std::size_t wall, const auto&) { around = judged.origins.walls[wall].shape; });
  if (around)
    found.warn(judged.origins.tool,
               "its home is inside a wall, the " + describe(around) + ": move home into free space");
  return std::move(found).take();
}

Diagnostics judgeUnits(const JudgedScene& judged) {
  constexpr double kMostArms = 5;       // a felt scene as large as so many arms' reaches
  constexpr double kLeastOfArm = 1e-3;  // ... or so small a part of one
  constexpr double kLargestBall = 0.1;  // parts of the reach
  constexpr double kSmallestBall = 5e-5;
  constexpr double kHeaviest = 50;  // [kg] that a person can move
  const HapticScene& scene = judged.scene;
  const double scale = scene.device.scale;
  const double reach = 2 * ReachOfArm::of(judged.device).radius * scale;
  Findings found;
  const Eigen::AlignedBox3d felt = boundsOfFelt(scene);
  const double size = felt.isEmpty() ? reach : felt.sizes().maxCoeff();
  const std::string across = "what is felt is " + lengthText(size) + " across, and the arm reaches over " +
                             lengthText(reach) + " of the scene: ";
  if (size > kMostArms * reach) {
    found.warn(somewhere(judged.origins),
               across +
                   "is it written in millimetres? One unit is one metre: put Scale { scaleFactor 0.001 0.001 0.001 "
                   "} before it, or give the HapticDevice a scale of " +
                   numberText(std::ceil(scale * size / reach)));
  } else if (size < kLeastOfArm * reach) {
    found.warn(somewhere(judged.origins), across +
                                              "one unit is one metre: scale it up, or give the HapticDevice a "
                                              "smaller scale");
  }
  const double radius = scene.tool.radius;
  if (radius > kLargestBall * reach || radius < kSmallestBall * reach) {
    found.warn(judged.origins.tool, "radius is " + lengthText(radius) + ", and the arm reaches over " +
                                        lengthText(reach) + " of the scene: write it in metres, 0.01 for a centimetre");
  }
  if (scene.tool.mass * scale > kHeaviest) {
    found.warn(judged.origins.tool,
               "the hand feels a mass of " + numberText(scene.tool.mass * scale) +
                   " kg (the tool's times the device's scale): write kilograms, 2 or so, divided by "
                   "the scale");
  }
  return std::move(found).take();
}

Diagnostics judgeZonesInReach(const JudgedScene& judged) {
  const HapticScene& scene = judged.scene;
  const ReachOfArm reach = ReachOfArm::of(judged.device);
  Findings found;
  for (std::size_t i = 0; i < scene.zones.size(); ++i) {
    const Zone& zone = scene.zones[i];
    const double beyond = reach.distanceTo(zone.shape, scene.device);
    if (beyond > scene.tool.radius) {
      found.warn(judged.origins.zones[i].shape, "is a zone that the arm cannot reach, by " +
                                                    lengthText(beyond - scene.tool.radius) +
                                                    ": move it, or the HapticDevice, or raise the device's scale");
    } else if (isBuried(zone, scene)) {
      found.warn(judged.origins.zones[i].shape,
                 "is a zone wholly inside a wall, where the ball cannot come: move it out, or take the wall away");
    }
  }
  return std::move(found).take();
}

Diagnostics judgeAnchors(const JudgedScene& judged) {
  constexpr double kRounding = 1e-6;  // of the zone's size: Coin's matrices are single precision
  Findings found;
  for (std::size_t i = 0; i < judged.scene.zones.size(); ++i) {
    const Zone& zone = judged.scene.zones[i];
    if (zone.kind == Zone::Kind::viscous) continue;
    const double outside = nearestSurface(zone.shape, zone.anchor).distance;
    if (outside <= kRounding * zone.shape.axes.norm()) continue;
    found.warn(judged.origins.zones[i].property, "its anchor is " + lengthText(outside) +
                                                     " outside of the zone, where the ball is let go before it gets "
                                                     "there: move it inside (it is in the shape's own coordinates)");
  }
  return std::move(found).take();
}

Diagnostics judgeLabels(const JudgedScene& judged) {
  Findings found;
  std::unordered_map<std::string, const SoNode*> first;
  for (const SoNode* node : judged.origins.properties) {
    const auto* label = dynamic_cast<const SoSFString*>(node->getField("label"));
    if (!label || label->getValue().getLength() == 0) continue;
    if (!first.emplace(label->getValue().getString(), node).second)
      found.warn(node,
                 "has the label of a property before it: logs and --set cannot tell them apart; give each its own");
  }
  return std::move(found).take();
}

}  // namespace haptiv
