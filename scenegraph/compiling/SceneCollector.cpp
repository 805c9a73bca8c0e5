#include "scenegraph/compiling/SceneCollector.h"

#include <Inventor/SbMatrix.h>
#include <Inventor/VRMLnodes/SoVRMLLOD.h>
#include <Inventor/draggers/SoDragger.h>
#include <Inventor/misc/SoChildList.h>
#include <Inventor/nodes/SoLOD.h>
#include <Inventor/nodes/SoLevelOfDetail.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShape.h>

#include <utility>

#include "scenegraph/Keyword.h"
#include "scenegraph/ToEigen.h"
#include "scenegraph/compiling/PropertyChecks.h"
#include "scenegraph/nodes/SoHapticDevice.h"
#include "scenegraph/nodes/SoHapticProperty.h"
#include "scenegraph/nodes/SoHapticTool.h"

namespace haptiv {
namespace {

using Severity = Diagnostic::Severity;
using Response = SoCallbackAction::Response;

}  // namespace

SceneCollector::SceneCollector(SceneMemory& memory, Progress progress, std::size_t mostTriangles)
    : memory_(memory), progress_(std::move(progress)), mostTriangles_(mostTriangles) {}

void SceneCollector::collect(SoNode* root) {
  memory_.ids.begin();
  memory_.separators.begin();
  memory_.met.begin();
  if (memory_.scene) {
    scene.walls.reserve(memory_.scene->walls.size() + 16);
    scene.zones.reserve(memory_.scene->zones.size() + 16);
    origins.walls.reserve(memory_.scene->walls.size() + 16);
    origins.properties.reserve(memory_.scene->walls.size() + 16);
  }
  SoCallbackAction action;
  action.addPreCallback(SoHapticProperty::getClassTypeId(), &onProperty, this);
  action.addPreCallback(SoSeparator::getClassTypeId(), &onSeparator, this);
  action.addPreCallback(SoHapticTool::getClassTypeId(), &onTool, this);
  action.addPreCallback(SoHapticDevice::getClassTypeId(), &onDevice, this);
  action.addPreCallback(SoShape::getClassTypeId(), &onShape, this);
  action.addTriangleCallback(SoShape::getClassTypeId(), &onTriangle, this);
  action.addPostCallback(SoShape::getClassTypeId(), &onShapeEnd, this);
  for (const SoType levels :
       {SoLOD::getClassTypeId(), SoLevelOfDetail::getClassTypeId(), SoVRMLLOD::getClassTypeId()}) {
    action.addPreCallback(levels, &onLevels, this);
  }
  action.addPreCallback(SoDragger::getClassTypeId(), &onDragger, this);
  action.apply(root);
  memory_.meshes.forgetUnused();
  if (!origins.tool) {
    say(Severity::error, root,
        "the scene has no tool: add HapticTool { home 0 0 0 } where the ball is to start, or make it solid: haptiv run "
        "--solid");
  }
}

Response SceneCollector::onProperty(void* self, SoCallbackAction*, const SoNode* node) {
  static_cast<SceneCollector*>(self)->check(node);
  return SoCallbackAction::CONTINUE;
}

Response SceneCollector::onTool(void* self, SoCallbackAction* action, const SoNode* node) {
  auto& collector = *static_cast<SceneCollector*>(self);
  collector.check(node);
  collector.checkPlace(node, *action);
  collector.takeTool(*static_cast<const SoHapticTool*>(node));
  return SoCallbackAction::CONTINUE;
}

Response SceneCollector::onDevice(void* self, SoCallbackAction* action, const SoNode* node) {
  auto& collector = *static_cast<SceneCollector*>(self);
  collector.check(node);
  collector.checkPlace(node, *action);
  collector.takeDevice(*static_cast<const SoHapticDevice*>(node));
  return SoCallbackAction::CONTINUE;
}

// Coin would choose by the camera, which is nothing to the hand.
Response SceneCollector::onLevels(void*, SoCallbackAction* action, const SoNode* node) {
  SoChildList* levels = node->getChildren();
  if (levels && levels->getLength() > 0) levels->traverse(action, 0);
  return SoCallbackAction::PRUNE;
}

// The handles of an editor are no part of the scene.
Response SceneCollector::onDragger(void*, SoCallbackAction*, const SoNode*) {
  return SoCallbackAction::PRUNE;
}

void SceneCollector::takeTool(const SoHapticTool& tool) {
  if (origins.tool) {
    say(Severity::error, &tool, "is a second tool: a scene has one; remove all HapticTool nodes but one");
    return;
  }
  origins.tool = &tool;
  scene.tool = {tool.mass.getValue(), tool.damping.getValue(), tool.radius.getValue(), toEigen(tool.home.getValue())};
}

void SceneCollector::takeDevice(const SoHapticDevice& device) {
  if (origins.device) {
    say(Severity::error, &device, "is a second device: a scene has one; remove all HapticDevice nodes but one");
    return;
  }
  origins.device = &device;
  scene.device = {device.description.getValue().getString(), toEigen(device.position.getValue()),
                  toEigen(device.orientation.getValue()), device.scale.getValue()};
}

void SceneCollector::check(const SoNode* node) {
  if (!memory_.met.meet(memory_.met.placeOf(node))) return;
  if (node->isOfType(SoHapticProperty::getClassTypeId())) origins.properties.push_back(node);
  for (const FieldFault& fault : checkFields(node)) say(fault.severity, node, fault.message);
}

void SceneCollector::note(const KnownSeparators::Property& property) {
  if (memory_.met.meet(property.place)) origins.properties.push_back(property.node);
}

void SceneCollector::checkPlace(const SoNode* node, SoCallbackAction& action) {
  if (action.getModelMatrix() == SbMatrix::identity()) return;
  say(Severity::warning, node,
      "stands after a transform, which does not move it (its fields are in the scene's coordinates): "
      "put it before the transform");
}

void SceneCollector::say(Severity severity, const SoNode* node, const std::string& message) {
  if (!said_.emplace(node, message).second) return;
  diagnostics.push_back({severity, {}, 0, describe(node), message, node});
}

}  // namespace haptiv
