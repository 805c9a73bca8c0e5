#include "scenegraph/compiling/SceneCollector.h"

#include <Inventor/SbMatrix.h>
#include <Inventor/draggers/SoDragger.h>
#include <Inventor/nodes/SoShape.h>

#include <Eigen/Geometry>

#include "scenegraph/Keyword.h"
#include "scenegraph/compiling/PropertyChecks.h"
#include "scenegraph/compiling/ShapeConversion.h"
#include "scenegraph/nodes/SoHapticDevice.h"
#include "scenegraph/nodes/SoHapticPropertyElement.h"
#include "scenegraph/nodes/SoHapticSpringZone.h"
#include "scenegraph/nodes/SoHapticSurface.h"
#include "scenegraph/nodes/SoHapticTool.h"
#include "scenegraph/nodes/SoHapticViscousZone.h"

namespace haptiv {
namespace {

using Severity = Diagnostic::Severity;
using Response = SoCallbackAction::Response;

Vector3 toEigen(const SbVec3f& v) {
  return Vector3(v[0], v[1], v[2]);
}

Matrix3 toEigen(const SbRotation& rotation) {
  const float* q = rotation.getValue();  // x, y, z, w
  return Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized().toRotationMatrix();
}

SurfaceProperties propertiesOf(const SoHapticSurface& node) {
  return {node.stiffness.getValue(), node.damping.getValue(), node.hysteresis.getValue(),
          node.staticFriction.getValue(), node.dynamicFriction.getValue()};
}

}  // namespace

SceneCollector::SceneCollector(std::function<ShapeId(const SoPath&)> idOf) : idOf_(std::move(idOf)) {}

void SceneCollector::collect(SoNode* root) {
  SoCallbackAction action;
  action.addPreCallback(SoHapticProperty::getClassTypeId(), &onProperty, this);
  action.addPreCallback(SoHapticTool::getClassTypeId(), &onTool, this);
  action.addPreCallback(SoHapticDevice::getClassTypeId(), &onDevice, this);
  action.addPreCallback(SoShape::getClassTypeId(), &onShape, this);
  action.addPreCallback(SoDragger::getClassTypeId(), &onDragger, this);
  action.apply(root);
  if (!tool_) {
    say(Severity::error, nullptr, "the scene has no tool: add HapticTool { home 0 0 0 } where the ball is to start");
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

Response SceneCollector::onShape(void* self, SoCallbackAction* action, const SoNode* node) {
  const SoHapticProperty* property = SoHapticPropertyElement::get(action->getState());
  if (property && property->isFelt()) static_cast<SceneCollector*>(self)->takeShape(*property, node, *action);
  return SoCallbackAction::PRUNE;  // no triangles are wanted
}

// The handles of an editor are no part of the scene.
Response SceneCollector::onDragger(void*, SoCallbackAction*, const SoNode*) {
  return SoCallbackAction::PRUNE;
}

void SceneCollector::takeTool(const SoHapticTool& tool) {
  if (tool_) {
    say(Severity::error, &tool, "is a second tool: a scene has one; remove all HapticTool nodes but one");
    return;
  }
  tool_ = &tool;
  scene.tool = {tool.mass.getValue(), tool.damping.getValue(), tool.radius.getValue(), toEigen(tool.home.getValue())};
}

void SceneCollector::takeDevice(const SoHapticDevice& device) {
  if (device_) {
    say(Severity::error, &device, "is a second device: a scene has one; remove all HapticDevice nodes but one");
    return;
  }
  device_ = &device;
  scene.device = {device.description.getValue().getString(), toEigen(device.position.getValue()),
                  toEigen(device.orientation.getValue()), device.scale.getValue()};
}

void SceneCollector::takeShape(const SoHapticProperty& property, const SoNode* node, SoCallbackAction& action) {
  if (!isExactShape(node)) {
    say(Severity::warning, node,
        "is not felt yet: use Cube, Sphere, Cylinder or Cone, or put HapticNone { } before it");
    return;
  }
  const ConvertedShape converted = convertShape(node, action.getModelMatrix());
  if (!converted.remark.empty()) {
    say(converted.isError ? Severity::error : Severity::warning, node, converted.remark);
  }
  if (converted.shape) add(property, *converted.shape, action);
}

void SceneCollector::add(const SoHapticProperty& property, const Shape& shape, SoCallbackAction& action) {
  const ShapeId id = idOf_(*action.getCurPath());
  if (const auto* surface = dynamic_cast<const SoHapticSurface*>(&property)) {
    Wall wall;
    wall.id = id;
    wall.shape = shape;
    wall.surface = propertiesOf(*surface);
    scene.walls.push_back(wall);
    return;
  }
  Zone zone;
  zone.id = id;
  zone.shape = shape;
  if (const auto* viscous = dynamic_cast<const SoHapticViscousZone*>(&property)) {
    zone.kind = Zone::Kind::viscous;
    zone.damping = viscous->damping.getValue();
  } else if (const auto* spring = dynamic_cast<const SoHapticSpringZone*>(&property)) {
    zone.kind = Zone::Kind::spring;
    zone.stiffness = spring->stiffness.getValue();
    zone.restLength = spring->restLength.getValue();
    zone.anchor = transformPoint(action.getModelMatrix(), toEigen(spring->anchor.getValue()));
  }
  scene.zones.push_back(zone);
}

void SceneCollector::check(const SoNode* node) {
  if (!checked_.insert(node).second) return;
  for (const FieldFault& fault : checkFields(node)) say(fault.severity, node, fault.message);
}

void SceneCollector::checkPlace(const SoNode* node, SoCallbackAction& action) {
  if (action.getModelMatrix() == SbMatrix::identity()) return;
  say(Severity::warning, node,
      "stands after a transform, which does not move it (its fields are in the scene's coordinates): "
      "put it before the transform");
}

void SceneCollector::say(Severity severity, const SoNode* node, const std::string& message) {
  if (!said_.emplace(node, message).second) return;
  diagnostics.push_back({severity, {}, 0, node ? describe(node) : std::string(), message, node});
}

}  // namespace haptiv
