#include "scenegraph/solid/MakeSolid.h"

#include <Inventor/SbBox3f.h>

#include <algorithm>

#include "device/kinematics/ArmKinematics.h"
#include "scenegraph/GraphWalk.h"
#include "scenegraph/ToEigen.h"
#include "scenegraph/judging/ContactDynamics.h"
#include "scenegraph/nodes/SoHapticDevice.h"
#include "scenegraph/nodes/SoHapticSurface.h"
#include "scenegraph/nodes/SoHapticTool.h"
#include "scenegraph/solid/SolidModel.h"

namespace haptiv {
namespace {

constexpr double kRoom = 0.2;       // half of what is used of the arm's reach around its home, each way [m]
constexpr double kBall = 0.02;      // radius of the ball, of the model's largest size
constexpr double kClearance = 1.5;  // of the ball's middle from the model's box, in radii
constexpr double kFeltMass = 2;     // [kg]
constexpr double kFeltDamping = 5;  // in free motion [N s/m]
constexpr double kOfBandwidth = 4;  // the wall's natural frequency is this part of the drives'

SbVec3f toCoin(const Vector3& v) {
  const Eigen::Vector3f f = v.cast<float>();
  return {f.x(), f.y(), f.z()};
}

template <typename Node>
bool has(const std::vector<SoNode*>& nodes) {
  return std::ranges::any_of(nodes, [](const SoNode* node) { return node->isOfType(Node::getClassTypeId()); });
}

NodeRef<> makeDevice(const SolidSizes& sizes, const DeviceDescription& device) {
  auto* node = new SoHapticDevice;
  const NodeRef<> kept(node);
  node->description = device.name.c_str();
  node->position = toCoin(sizes.device.position);
  node->scale = static_cast<float>(sizes.device.scale);
  return kept;
}

NodeRef<> makeTool(const Tool& tool) {
  auto* node = new SoHapticTool;
  const NodeRef<> kept(node);
  node->mass = static_cast<float>(tool.mass);
  node->damping = static_cast<float>(tool.damping);
  node->radius = static_cast<float>(tool.radius);
  node->home = toCoin(tool.home);
  return kept;
}

NodeRef<> makeSurface(const SurfaceProperties& surface) {
  auto* node = new SoHapticSurface;
  const NodeRef<> kept(node);
  node->stiffness = static_cast<float>(surface.stiffness);
  node->damping = static_cast<float>(surface.damping);
  node->label = "solid";
  return kept;
}

}  // namespace

SolidSizes SolidSizes::of(const SbBox3f& model, const DeviceDescription& device) {
  const Vector3 low = toEigen(model.getMin());
  const Vector3 high = toEigen(model.getMax());
  const Vector3 centre = (low + high) / 2;
  const double size = (high - low).maxCoeff();

  SolidSizes sizes;
  sizes.tool.radius = kBall * size;
  sizes.tool.home = {centre.x(), centre.y(), high.z() + kClearance * sizes.tool.radius};
  sizes.device.description = device.name;
  sizes.device.scale = (size / 2 + 2 * kClearance * sizes.tool.radius) / kRoom;
  sizes.device.position = centre - sizes.device.scale * ArmKinematics(device).forward(device.homeAngles).position;

  const double frequency = device.drives.bandwidth.minCoeff() / kOfBandwidth;
  ContactDynamics felt{kFeltMass, kFeltMass * frequency * frequency, 0};
  sizes.tool.mass = kFeltMass / sizes.device.scale;
  sizes.tool.damping = kFeltDamping / sizes.device.scale;
  sizes.surface.stiffness = felt.stiffness / sizes.device.scale;
  sizes.surface.damping = felt.optimalDamping() / sizes.device.scale;
  return sizes;
}

std::vector<NodeRef<>> solidNodes(SoNode* root, const DeviceDescription& device) {
  const SbBox3f model = modelBounds(root);
  if (!solidFault(model).empty()) return {};
  const std::vector<SoNode*> present = writtenNodes(root);
  const SolidSizes sizes = SolidSizes::of(model, device);
  std::vector<NodeRef<>> nodes;
  if (!has<SoHapticDevice>(present)) nodes.push_back(makeDevice(sizes, device));
  if (!has<SoHapticTool>(present)) nodes.push_back(makeTool(sizes.tool));
  if (!has<SoHapticProperty>(present)) nodes.push_back(makeSurface(sizes.surface));
  return nodes;
}

}  // namespace haptiv
