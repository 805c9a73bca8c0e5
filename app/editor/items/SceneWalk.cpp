#include "app/editor/items/SceneWalk.h"

#include <Inventor/VRMLnodes/SoVRMLGroup.h>
#include <Inventor/VRMLnodes/SoVRMLLOD.h>
#include <Inventor/VRMLnodes/SoVRMLSwitch.h>
#include <Inventor/fields/SoSFString.h>
#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoLOD.h>
#include <Inventor/nodes/SoLevelOfDetail.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoSwitch.h>

#include <algorithm>

#include "app/editor/items/NodeRoles.h"
#include "scenegraph/nodes/SoHapticNone.h"
#include "scenegraph/nodes/SoHapticRubberBand.h"
#include "scenegraph/nodes/SoHapticSurface.h"
#include "scenegraph/nodes/SoHapticViscousZone.h"

namespace haptiv {
namespace {

constexpr int kMaxDepth = 256;  // as deep as a scene file may nest

/// What is inherited to the right and downwards.
struct State {
  const SoNode* property = nullptr;
  QColor colour = QColor::fromRgbF(0.8, 0.8, 0.8);
};

QColor toColour(const SbColor& colour) {
  return QColor::fromRgbF(colour[0], colour[1], colour[2]);
}

QString textOf(const SoNode& node, const char* fieldName) {
  const auto* field = dynamic_cast<const SoSFString*>(node.getField(fieldName));
  return field ? QString::fromUtf8(field->getValue().getString()) : QString();
}

SceneItem::Kind kindOfShape(const SoNode* property) {
  if (!property) return SceneItem::Kind::scenery;
  const SoType type = property->getTypeId();
  if (type == SoHapticSurface::getClassTypeId()) return SceneItem::Kind::wall;
  if (type == SoHapticViscousZone::getClassTypeId()) return SceneItem::Kind::dampingZone;
  if (type == SoHapticRubberBand::getClassTypeId()) return SceneItem::Kind::rubberBand;
  return type == SoHapticNone::getClassTypeId() ? SceneItem::Kind::scenery : SceneItem::Kind::springZone;
}

QString stemOf(const SceneItem& item) {
  switch (item.kind) {
    case SceneItem::Kind::wall:
      return "wall";
    case SceneItem::Kind::dampingZone:
      return "damping zone";
    case SceneItem::Kind::springZone:
      return "spring zone";
    case SceneItem::Kind::rubberBand:
      return "rubber band";
    case SceneItem::Kind::tool:
      return "ball";
    case SceneItem::Kind::device:
      return textOf(*item.node, "description");
    case SceneItem::Kind::scenery:
      break;
  }
  return keyword(*item.node).toLower();
}

/// The only child that is visited, or what SoSwitch says of none and all.
int chosenChild(const SoGroup& group, Role role) {
  if (role == Role::separator) return SO_SWITCH_ALL;
  if (const auto* choice = dynamic_cast<const SoSwitch*>(&group)) return choice->whichChild.getValue();
  if (const auto* choice = dynamic_cast<const SoVRMLSwitch*>(&group)) return choice->whichChoice.getValue();
  for (const SoType levels :
       {SoLOD::getClassTypeId(), SoLevelOfDetail::getClassTypeId(), SoVRMLLOD::getClassTypeId()}) {
    if (group.isOfType(levels)) return 0;  // the finest, which is felt
  }
  return SO_SWITCH_ALL;
}

/// Whether what is said in the group ends with it.
bool keepsToItself(const SoGroup& group, Role role) {
  return role == Role::separator || group.isOfType(SoSeparator::getClassTypeId()) ||
         group.isOfType(SoVRMLGroup::getClassTypeId());
}

class Walk {
 public:
  explicit Walk(bool named) : named_(named) {}

  void visit(SoNode* node, State& state) {
    switch (const Role role = roles_(*node); role) {
      case Role::property:
        state.property = node;
        break;
      case Role::tool:
        add(node, SceneItem::Kind::tool, State{});
        break;
      case Role::device:
        add(node, SceneItem::Kind::device, State{});
        break;
      case Role::material:
        takeColour(static_cast<SoMaterial*>(node)->diffuseColor, state);
        break;
      case Role::baseColor:
        takeColour(static_cast<SoBaseColor*>(node)->rgb, state);
        break;
      case Role::shape:
        add(node, kindOfShape(state.property), state);
        break;
      case Role::separator:
      case Role::group:
        visitChildren(static_cast<SoGroup*>(node), role, state);
        break;
      case Role::unknown:
      case Role::other:
        break;
    }
  }

  std::vector<SceneItem> take() { return std::move(items_); }

 private:
  void visitChildren(SoGroup* group, Role role, State& state) {
    if (place_.size() >= kMaxDepth) return;
    State inner = state;
    int first = 0;
    int end = group->getNumChildren();
    const int which = chosenChild(*group, role);
    if (which == SO_SWITCH_NONE) return;
    if (which >= 0) {
      first = std::min(which, end);
      end = std::min(which + 1, end);
    }
    names_.push_back(named_ ? group->getName().getString() : nullptr);
    for (int i = first; i < end; ++i) {
      place_.push_back(i);
      visit(group->getChild(i), inner);
      place_.pop_back();
    }
    names_.pop_back();
    if (!keepsToItself(*group, role)) state = inner;
  }

  static void takeColour(const SoMFColor& colours, State& state) {
    if (colours.getNum() > 0) state.colour = toColour(colours[0]);
  }

  void add(const SoNode* node, SceneItem::Kind kind, const State& state) {
    SceneItem item{kind, place_, node, state.property, {}, {}, state.colour};
    if (!named_) return items_.push_back(std::move(item));
    if (state.property) item.label = textOf(*state.property, "label");
    item.name = item.label;
    if (item.name.isEmpty()) item.name = node->getName().getString();
    if (item.name.isEmpty() && names_.size() > 1) item.name = QString::fromUtf8(names_.back());
    if (item.name.isEmpty()) item.name = stemOf(item);
    items_.push_back(std::move(item));
  }

  bool named_;
  NodeRoles roles_;
  ScenePlace place_;
  std::vector<const char*> names_;  ///< DEF names of the groups on the way
  std::vector<SceneItem> items_;
};

}  // namespace

std::vector<SceneItem> walkScene(SoSeparator& root, Naming naming) {
  Walk walk(naming == Naming::full);
  State state;
  walk.visit(&root, state);
  return walk.take();
}

}  // namespace haptiv
