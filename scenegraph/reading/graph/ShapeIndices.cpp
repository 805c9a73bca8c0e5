#include "scenegraph/reading/graph/ShapeIndices.h"

#include <Inventor/VRMLnodes/SoVRMLScript.h>
#include <Inventor/nodes/SoLOD.h>
#include <Inventor/nodes/SoLevelOfDetail.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>

#include "scenegraph/GraphWalk.h"
#include "scenegraph/reading/graph/ShapeCheck.h"

namespace haptiv {
namespace {

/// Goes through the graph as actions do. Recursive: expansionFault has bounded the depth.
class IndexWalk {
 public:
  IndexWalk(ShapeCheck& check, IndexFaults& faults) : check_(check), faults_(faults) {}

  void visit(const SoNode* node, AttributesInForce& state) {
    state.update(node);
    if (check_(node, state)) return;
    if (!node->isOfType(SoVRMLScript::getClassTypeId()))  // its fields only refer to nodes: to itself, perhaps
      visitChildren(node, state);
  }

 private:
  void visitChildren(const SoNode* node, AttributesInForce& state) {
    const AttributesInForce before = state;
    const auto children = writtenChildren(node);
    const auto* choice = dynamic_cast<const SoSwitch*>(node);
    const bool isLevels = dynamic_cast<const SoLOD*>(node) || dynamic_cast<const SoLevelOfDetail*>(node);
    const int chosen = choice ? choice->whichChild.getValue() : 0;
    const bool all = !isLevels && (!choice || chosen == SO_SWITCH_ALL);
    const bool canChange = !choice || choice->whichChild.isConnected();
    for (std::size_t i = 0; i < children.size(); ++i) {
      AttributesInForce aside = before;  // what is not chosen may be shown later, and changes nothing after it
      const bool isChosen = all || static_cast<int>(i) == chosen;
      const bool wasHidden = faults_.hide(faults_.isHidden() || (!isChosen && !canChange));
      visit(children[i], isChosen ? state : aside);
      faults_.hide(wasHidden);
    }
    const bool leaks = node->isOfType(SoGroup::getClassTypeId()) && !node->isOfType(SoSeparator::getClassTypeId());
    if (!leaks) state = before;
  }

  ShapeCheck& check_;
  IndexFaults& faults_;
};

}  // namespace

Diagnostics shapeIndexFaults(SoNode* root) {
  IndexFaults faults;
  ShapeCheck check(faults);
  AttributesInForce state;
  IndexWalk(check, faults).visit(root, state);
  Diagnostics found = faults.take();
  if (!hasErrors(found)) check.mending().mend(root);
  return found;
}

}  // namespace haptiv
