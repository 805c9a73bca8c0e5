#include "scenegraph/compiling/SceneCollector.h"

#include <Inventor/SbMatrix.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/VRMLnodes/SoVRMLLOD.h>
#include <Inventor/draggers/SoDragger.h>
#include <Inventor/elements/SoComplexityElement.h>
#include <Inventor/misc/SoChildList.h>
#include <Inventor/nodes/SoLOD.h>
#include <Inventor/nodes/SoLevelOfDetail.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShape.h>
#include <Inventor/nodes/SoText3.h>
#include <Inventor/nodes/SoVertexShape.h>

#include <algorithm>

#include "scenegraph/Keyword.h"
#include "scenegraph/ToEigen.h"
#include "scenegraph/compiling/PropertyChecks.h"
#include "scenegraph/compiling/ShapeConversion.h"
#include "scenegraph/nodes/SoHapticDevice.h"
#include "scenegraph/nodes/SoHapticProperty.h"
#include "scenegraph/nodes/SoHapticPropertyElement.h"
#include "scenegraph/nodes/SoHapticTool.h"

namespace haptiv {
namespace {

using Severity = Diagnostic::Severity;
using Response = SoCallbackAction::Response;

constexpr float kFinest = 1;  // complexity of what Coin cuts into triangles itself

/// Of the shape that the action is at.
FeltShape feltOf(ShapeId id, const SoNode* node, SoCallbackAction& action) {
  return {id, node, *SoHapticPropertyElement::get(action.getState()), action.getModelMatrix()};
}

/// Whether its triangles are given by its coordinates, not by a fineness of Coin's choice.
bool isMadeOfCorners(const SoNode* node) {
  return node->isOfType(SoVertexShape::getClassTypeId()) || node->isOfType(SoText3::getClassTypeId());
}

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
    say(Severity::error, nullptr,
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

// Most of a large scene is read without Coin.
Response SceneCollector::onSeparator(void* self, SoCallbackAction* action, const SoNode* node) {
  if (node->getTypeId() != SoSeparator::getClassTypeId()) return SoCallbackAction::CONTINUE;
  auto& collector = *static_cast<SceneCollector*>(self);
  const auto& separator = *static_cast<const SoSeparator*>(node);
  const PathIds::Way way = collector.memory_.ids.wayToParent(*action->getCurPath());
  if (!collector.takePlain(separator, collector.surroundings(way, *action))) collector.walk(separator, *action);
  return SoCallbackAction::PRUNE;
}

Response SceneCollector::onShape(void* self, SoCallbackAction* action, const SoNode* node) {
  const SoHapticProperty* property = SoHapticPropertyElement::get(action->getState());
  if (!property || !property->isFelt()) return SoCallbackAction::PRUNE;
  return static_cast<SceneCollector*>(self)->takeShape(node, *action) ? SoCallbackAction::CONTINUE
                                                                      : SoCallbackAction::PRUNE;
}

void SceneCollector::onTriangle(void* self, SoCallbackAction*, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
                                const SoPrimitiveVertex* c) {
  auto& collector = *static_cast<SceneCollector*>(self);
  if (!collector.open_ || collector.triangles_ > collector.mostTriangles_) return;
  collector.open_->soup.add(a->getPoint(), b->getPoint(), c->getPoint());
  ++collector.triangles_;
  constexpr std::size_t kOften = 1 << 16;
  if (collector.triangles_ % kOften == 0) collector.tellProgress();
}

Response SceneCollector::onShapeEnd(void* self, SoCallbackAction* action, const SoNode* node) {
  auto& collector = *static_cast<SceneCollector*>(self);
  if (collector.open_) collector.endMesh(node, *action);
  return collector.triangles_ > collector.mostTriangles_ ? SoCallbackAction::ABORT : SoCallbackAction::CONTINUE;
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

bool SceneCollector::takeShape(const SoNode* node, SoCallbackAction& action) {
  ConvertedShape converted = convertShape(node, action.getModelMatrix());
  if (!converted.fault.empty()) {
    say(Severity::error, node, converted.fault);
    return false;
  }
  if (!converted.shape) return beginMesh(node, action);
  add(feltOf(memory_.ids.idOf(*action.getCurPath()), node, action), std::move(*converted.shape));
  return false;
}

bool SceneCollector::beginMesh(const SoNode* node, SoCallbackAction& action) {
  const float complexityBefore = action.getComplexity();
  if (!isMadeOfCorners(node)) SoComplexityElement::set(action.getState(), kFinest);
  const ShapeId id = memory_.ids.idOf(*action.getCurPath());
  MeshSource source = MeshSource::of(node, action);
  if (auto known = memory_.meshes.find(id, source)) {
    triangles_ += known->triangles.size();
    add(feltOf(id, node, action), shapeOf(std::move(known)));
    SoComplexityElement::set(action.getState(), complexityBefore);
    return false;
  }
  TriangleSoup soup(source.toW, source.isClockwise);
  open_.emplace(OpenMesh{id, std::move(source), std::move(soup), complexityBefore});
  return true;
}

void SceneCollector::endMesh(const SoNode* node, SoCallbackAction& action) {
  OpenMesh ended = std::move(*open_);
  open_.reset();
  SoComplexityElement::set(action.getState(), ended.complexityBefore);
  if (triangles_ > mostTriangles_) {
    say(Severity::error, node,
        "brings what is felt beyond " + std::to_string(mostTriangles_) +
            " triangles: put HapticNone { } before what need not be felt, or make the meshes coarser");
    return;
  }
  if (!ended.soup.isFinite()) {
    say(Severity::error, node, "has corners that are not finite: correct the numbers of its points and transforms");
    return;
  }
  auto mesh = ended.soup.makeMesh();
  if (!mesh) {
    say(Severity::warning, node,
        "is not felt: it has no faces, as lines and points have none, or no area: put HapticNone { } before it, or "
        "give "
        "it faces");
    return;
  }
  memory_.meshes.keep(ended.id, std::move(ended.source), mesh);
  add(feltOf(ended.id, node, action), shapeOf(std::move(mesh)));
}

void SceneCollector::add(const FeltShape& felt, Shape shape) {
  constexpr std::size_t kOften = 1 << 12;
  if ((scene.walls.size() + scene.zones.size() + 1) % kOften == 0) tellProgress();
  addFelt(felt, std::move(shape), scene, origins);
}

void SceneCollector::tellProgress() const {
  if (progress_) progress_(scene.walls.size() + scene.zones.size(), triangles_);
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
  diagnostics.push_back({severity, {}, 0, node ? describe(node) : std::string(), message, node});
}

}  // namespace haptiv
