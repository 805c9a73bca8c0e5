#include "scenegraph/reading/graph/NurbsSwitch.h"

#include <Inventor/fields/SoMFNode.h>
#include <Inventor/fields/SoSFNode.h>
#include <Inventor/nodes/SoGroup.h>
#include <Inventor/nodes/SoSwitch.h>

#include <unordered_set>

#include "scenegraph/GraphWalk.h"
#include "scenegraph/NodeRef.h"
#include "scenegraph/reading/graph/NurbsRules.h"

namespace haptiv {
namespace {

using Shapes = std::unordered_set<const SoNode*>;

void replaceChildren(SoGroup* group, const Shapes& shapes) {
  for (int i = 0; i < group->getNumChildren(); ++i) {
    SoNode* child = group->getChild(i);
    if (!shapes.contains(child)) continue;
    auto* off = new SoSwitch;  // whichChild is SO_SWITCH_NONE
    off->addChild(child);
    group->replaceChild(i, off);
  }
}

void clearFields(SoNode* node, const Shapes& shapes) {
  for (SoField* field : fieldsOf(node)) {
    if (auto* one = dynamic_cast<SoSFNode*>(field); one && shapes.contains(one->getValue())) one->setValue(nullptr);
    if (auto* many = dynamic_cast<SoMFNode*>(field)) {
      for (int k = many->getNum() - 1; k >= 0; --k) {
        if (shapes.contains((*many)[k])) many->deleteValues(k, 1);
      }
    }
  }
}

}  // namespace

std::vector<const SoNode*> switchOffEmptyNurbs(SoNode* root) {
  std::vector<const SoNode*> shapes;
  const std::vector<SoNode*> nodes = writtenNodes(root);
  for (SoNode* node : nodes) {
    if (isEmptyNurbs(node)) shapes.push_back(node);
  }
  if (shapes.empty()) return shapes;
  const Shapes off(shapes.begin(), shapes.end());
  std::vector<NodeRef<SoNode>> kept;  // a field may be the last that holds one
  for (SoNode* node : nodes) kept.emplace_back(node);
  for (SoNode* node : nodes) {
    clearFields(node, off);
    if (auto* group = dynamic_cast<SoGroup*>(node)) replaceChildren(group, off);
  }
  return shapes;
}

}  // namespace haptiv
