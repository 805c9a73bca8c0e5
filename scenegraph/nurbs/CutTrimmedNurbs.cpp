#include "scenegraph/nurbs/CutTrimmedNurbs.h"

#include <Inventor/VRMLnodes/SoVRMLLOD.h>
#include <Inventor/VRMLnodes/SoVRMLSwitch.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/elements/SoSwitchElement.h>
#include <Inventor/misc/SoChildList.h>
#include <Inventor/misc/SoState.h>
#include <Inventor/nodes/SoIndexedNurbsSurface.h>
#include <Inventor/nodes/SoLOD.h>
#include <Inventor/nodes/SoLevelOfDetail.h>
#include <Inventor/nodes/SoNurbsSurface.h>
#include <Inventor/nodes/SoProfile.h>
#include <Inventor/nodes/SoSwitch.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <utility>

#include "scenegraph/GraphWalk.h"
#include "scenegraph/nurbs/TrimmableNurbs.h"

namespace haptiv {
namespace {

using Response = SoCallbackAction::Response;

constexpr std::chrono::seconds kLongest{10};

/// Goes through a scene as actions do, and through what they might once choose to.
class Gathering {
 public:
  explicit Gathering(std::shared_ptr<NurbsCuts> cuts) : cuts_(std::move(cuts)) {
    action_.addPreCallback(SoShape::getClassTypeId(), &onShape, this);
    action_.addPreCallback(SoSwitch::getClassTypeId(), &onSwitch, this);
    for (const SoType levels : {SoLOD::getClassTypeId(), SoLevelOfDetail::getClassTypeId(), SoVRMLLOD::getClassTypeId(),
                                SoVRMLSwitch::getClassTypeId()}) {
      action_.addPreCallback(levels, &onLevels, this);
    }
  }

  void gather(SoNode* root) { action_.apply(root); }

  std::vector<TrimmedPlace> places;
  std::set<const SoNode*> leftOut;  ///< surfaces with too many profiles, or in more places than are kept

 private:
  static Response onShape(void* self, SoCallbackAction* action, const SoNode* node) {
    auto& gathering = *static_cast<Gathering*>(self);
    auto* surface = dynamic_cast<TrimmableNurbs*>(const_cast<SoNode*>(node));
    if (!surface) return SoCallbackAction::PRUNE;
    surface->cuts = gathering.cuts_;
    const auto place = TrimmedPlace::of(node, action->getState());
    if (place) gathering.take(*place);
    return SoCallbackAction::PRUNE;
  }

  void take(const TrimmedPlace& place) {
    if (known_.contains(place.key())) return;
    if (place.key().empty() || places.size() == NurbsCuts::kMostSurfaces) {
      leftOut.insert(place.surface());
      return;
    }
    known_.insert(place.key());
    places.push_back(place);
  }

  /// What is not chosen changes nothing after it.
  static void visitAside(SoCallbackAction* action, const SoNode* node, int chosen) {
    SoChildList* children = node->getChildren();
    for (int i = 0; i < children->getLength(); ++i) {
      if (i == chosen) continue;
      action->getState()->push();
      children->traverse(action, i);
      action->getState()->pop();
    }
  }

  static Response onSwitch(void*, SoCallbackAction* action, const SoNode* node) {
    int chosen = static_cast<const SoSwitch*>(node)->whichChild.getValue();
    if (chosen == SO_SWITCH_INHERIT) chosen = SoSwitchElement::get(action->getState());
    if (chosen != SO_SWITCH_ALL) visitAside(action, node, chosen);
    return SoCallbackAction::CONTINUE;
  }

  static Response onLevels(void*, SoCallbackAction* action, const SoNode* node) {
    visitAside(action, node, -1);
    return SoCallbackAction::PRUNE;
  }

  std::shared_ptr<NurbsCuts> cuts_;
  SoCallbackAction action_;
  std::set<TrimmedPlace::Key> known_;
};

template <typename... Nodes>
bool has(const std::vector<SoNode*>& nodes) {
  return std::ranges::any_of(nodes,
                             [](const SoNode* node) { return (node->isOfType(Nodes::getClassTypeId()) || ...); });
}

}  // namespace

std::vector<const SoNode*> cutTrimmedNurbs(SoNode* root) {
  const std::vector<SoNode*> nodes = writtenNodes(root);
  if (!has<SoProfile>(nodes) || !has<SoNurbsSurface, SoIndexedNurbsSurface>(nodes)) return {};
  const auto cuts = std::make_shared<NurbsCuts>();
  Gathering gathering(cuts);
  gathering.gather(root);
  cuts->cut(gathering.places, kLongest);
  std::set<const SoNode*> left = std::move(gathering.leftOut);
  for (const TrimmedPlace& place : gathering.places) {
    if (cuts->at(place).empty()) left.insert(place.surface());
  }
  std::vector<const SoNode*> inOrder;
  std::ranges::copy_if(nodes, std::back_inserter(inOrder), [&](const SoNode* node) { return left.contains(node); });
  return inOrder;
}

}  // namespace haptiv
