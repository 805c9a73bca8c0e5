#include "scenegraph/judging/ReachOfArm.h"

#include <algorithm>
#include <cmath>

#include "haptics/scene/DeviceFrames.h"
#include "haptics/shapes/ShapeDistance.h"

namespace haptiv {

ReachOfArm ReachOfArm::of(const DeviceDescription& device) {
  const double tool = device.tool.position.norm();
  const std::vector<ChainJoint>& joints = device.chain.joints;
  if (device.delta) {
    const DeltaGeometry& g = *device.delta;
    const double leg = g.baseRadius + std::abs(g.baseOffset) + g.upperArm + g.forearm + g.hinges + g.platformRadius;
    return {leg + tool, leg + tool};
  }
  if (joints.empty()) return {4 * device.links.scara + tool, 2 * device.links.lift + tool};
  double length = device.chain.end.position.norm() + tool;
  for (const ChainJoint& joint : joints) length += joint.mount.position.norm();
  return {length, length};
}

Vector3 ReachOfArm::nearest(const Vector3& p_B) const {
  const double across = p_B.head<2>().norm();
  Vector3 inside = p_B;
  if (across > radius) inside.head<2>() *= radius / across;
  inside.z() = std::clamp(p_B.z(), -halfHeight, halfHeight);
  return inside;
}

// The two are convex (a mesh is taken as if it were): going to and fro between them ends at their nearest places.
double ReachOfArm::distanceTo(const Shape& shape, const DevicePlacement& placed) const {
  constexpr int kSteps = 100;
  Vector3 inShape = shape.centre;
  double distance = 0;
  for (int step = 0; step < kSteps; ++step) {
    const Vector3 inReach = placeInScene(placed, nearest(placeInBase(placed, inShape)));
    const SurfacePoint surface = nearestSurface(shape, inReach);
    if (surface.distance <= 0) return 0;
    distance = surface.distance;
    inShape = inReach - distance * surface.normal;
  }
  return distance;
}

}  // namespace haptiv
