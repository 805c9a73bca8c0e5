// The part of SceneCollector that takes shapes: exact ones as such, all others by their triangles, as Coin makes them.
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/elements/SoComplexityElement.h>
#include <Inventor/nodes/SoText3.h>
#include <Inventor/nodes/SoVertexShape.h>

#include "scenegraph/compiling/SceneCollector.h"
#include "scenegraph/compiling/ShapeConversion.h"
#include "scenegraph/nodes/SoHapticProperty.h"
#include "scenegraph/nodes/SoHapticPropertyElement.h"

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
        "is not felt: it has no faces, as lines, points and pictures or text on the screen have none, or no area: put "
        "HapticNone { } before it, or give it faces");
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

}  // namespace haptiv
