#pragma once

#include <vector>

#include "device/described/DeviceDescription.h"
#include "haptics/scene/HapticScene.h"
#include "scenegraph/NodeRef.h"

class SbBox3f;

namespace haptiv {

/// Sizes by which a model becomes something that a device can feel.
struct SolidSizes {
  DevicePlacement device;
  Tool tool;
  SurfaceProperties surface;

  /// For a model of these bounds, in the scene's own unit. The model comes to fill what the arm reaches well around its
  /// home, by the device's scale s; the ball's radius is a fiftieth of the model, its home above it. Mass, damping and
  /// stiffness are such that the hand feels 2 kg and a wall of a quarter of the drives' bandwidth at the optimal
  /// damping (33), whatever the scale: what the hand feels is s times what stands in the scene.
  static SolidSizes of(const SbBox3f& model, const DeviceDescription& device);
};

/// What is to stand before all else in a scene that is only seen, in this order: the device and the tool, where the
/// graph has none, and a surface, where it has no haptic property. Empty where nothing lacks, or nothing is there to be
/// felt (solidFault). Does not change the graph.
std::vector<NodeRef<>> solidNodes(SoNode* root, const DeviceDescription& device);

}  // namespace haptiv
