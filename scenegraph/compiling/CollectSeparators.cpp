// The part of SceneCollector that reads plain Separators without Coin, and takes over those that have not changed.
#include <Inventor/misc/SoChildList.h>
#include <Inventor/misc/SoState.h>
#include <Inventor/nodes/SoSeparator.h>

#include <algorithm>

#include "scenegraph/compiling/SceneCollector.h"
#include "scenegraph/nodes/SoHapticProperty.h"
#include "scenegraph/nodes/SoHapticPropertyElement.h"

namespace haptiv {
namespace {

/// Another shape is as before.
void keep(KeptRuns& runs, std::size_t before, std::size_t now) {
  KeptRun* last = runs.empty() ? nullptr : &runs.back();
  if (last && last->before + last->count == before && last->now + last->count == now) {
    ++last->count;
  } else {
    runs.push_back({static_cast<std::uint32_t>(before), static_cast<std::uint32_t>(now), 1});
  }
}

/// A wall or zone as it was; should another one come to have its id, with a new one.
template <typename Felt>
void takeOver(const std::vector<Felt>& before, std::size_t number, ShapeId id, std::vector<Felt>& now, KeptRuns& runs) {
  now.push_back(before[number]);
  if (now.back().id == id) return keep(runs, number, now.size() - 1);
  now.back().id = id;
}

}  // namespace

SoCallbackAction::Response SceneCollector::onSeparator(void* self, SoCallbackAction* action, const SoNode* node) {
  if (node->getTypeId() != SoSeparator::getClassTypeId()) return SoCallbackAction::CONTINUE;
  auto& collector = *static_cast<SceneCollector*>(self);
  const auto& separator = *static_cast<const SoSeparator*>(node);
  const PathIds::Way way = collector.memory_.ids.wayToParent(*action->getCurPath());
  if (!collector.takePlain(separator, collector.surroundings(way, *action))) collector.walk(separator, *action);
  return SoCallbackAction::PRUNE;
}

void SceneCollector::walk(const SoSeparator& separator, SoCallbackAction& action) {
  const PathIds::Way way = memory_.ids.wayOf(*action.getCurPath());
  action.getState()->push();
  SoChildList& children = *separator.getChildren();
  std::optional<Surroundings> around;  // as long as nothing but Separators comes
  for (int i = 0; i < children.getLength() && !action.hasTerminated(); ++i) {
    const SoNode* child = children[i];
    if (child->getTypeId() == SoSeparator::getClassTypeId()) {
      if (!around) around = surroundings(way, action);
      if (takePlain(*static_cast<const SoSeparator*>(child), *around)) continue;
    }
    children.traverse(&action, i);
    around.reset();
  }
  action.getState()->pop();
}

Surroundings SceneCollector::surroundings(PathIds::Way way, SoCallbackAction& action) const {
  const SoHapticProperty* property = SoHapticPropertyElement::get(action.getState());
  return {way, action.getModelMatrix(), property, property ? property->getNodeId() : 0};
}

bool SceneCollector::takePlain(const SoSeparator& separator, const Surroundings& around) {
  const KnownSeparators::Separator* known = memory_.scene ? memory_.separators.find(separator, around) : nullptr;
  if (known) {
    takeKnown(*known, around);
    return true;
  }
  if (!plain_.read(separator, around.toW, around.property)) return false;
  takeRead(separator, around);
  return true;
}

void SceneCollector::takeRead(const SoSeparator& separator, const Surroundings& around) {
  const std::size_t firstWall = scene.walls.size(), firstZone = scene.zones.size();
  const PathIds::Way way = PathIds::wayOn(around.way, &separator);
  plainShapes_.clear();
  plainProperties_.clear();
  for (const SoHapticProperty* own : plain_.properties()) {
    check(own);
    plainProperties_.push_back({own, memory_.met.placeOf(own)});
  }
  for (PlainSeparator::Felt& felt : plain_.felt()) {
    const PathIds::Place place = memory_.ids.placeOf(PathIds::wayOn(way, felt.node));
    const std::size_t zones = scene.zones.size();
    add({memory_.ids.meet(place), felt.node, *felt.property, felt.toW}, std::move(felt.shape));
    plainShapes_.push_back({place, scene.zones.size() > zones, {felt.node, felt.property}});
  }
  const auto isFaulty = [&](const SoNode* own) {
    const auto first = said_.lower_bound({own, {}});
    return first != said_.end() && first->first == own;
  };
  if (std::ranges::any_of(plain_.properties(), isFaulty)) return;  // to be said again by the next compilation
  memory_.separators.note(separator, around, firstWall, firstZone, plainShapes_, plainProperties_);
}

void SceneCollector::takeKnown(const KnownSeparators::Separator& known, const Surroundings& around) {
  const std::size_t firstWall = scene.walls.size(), firstZone = scene.zones.size();
  const auto properties = memory_.separators.propertiesOf(known);
  const auto shapes = memory_.separators.shapesOf(known);
  for (const KnownSeparators::Property& own : properties) note(own);
  std::size_t wall = known.firstWall, zone = known.firstZone;
  for (const KnownSeparators::Shape& shape : shapes) {
    const ShapeId id = memory_.ids.meet(shape.place);
    if (shape.isZone) {
      takeOver(memory_.scene->zones, zone++, id, scene.zones, keptZones);
      origins.zones.push_back(shape.origin);
    } else {
      takeOver(memory_.scene->walls, wall++, id, scene.walls, keptWalls);
      origins.walls.push_back(shape.origin);
    }
  }
  memory_.separators.note(*known.node, around, firstWall, firstZone, shapes, properties);
}

}  // namespace haptiv
