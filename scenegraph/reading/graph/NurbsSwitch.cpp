#include "scenegraph/reading/graph/NurbsSwitch.h"

#include <Inventor/fields/SoMFNode.h>
#include <Inventor/fields/SoSFNode.h>
#include <Inventor/lists/SoFieldList.h>
#include <Inventor/nodes/SoGroup.h>
#include <Inventor/nodes/SoProfile.h>
#include <Inventor/nodes/SoSwitch.h>

#include <algorithm>

#include "scenegraph/NodeRef.h"
#include "scenegraph/reading/graph/GraphWalk.h"
#include "scenegraph/reading/graph/NurbsRules.h"

namespace haptiv {
namespace {

void replaceChildren(SoGroup* group) {
  for (int i = 0; i < group->getNumChildren(); ++i) {
    SoNode* child = group->getChild(i);
    if (!isNurbs(child)) continue;
    auto* off = new SoSwitch;  // whichChild is SO_SWITCH_NONE
    off->addChild(child);
    group->replaceChild(i, off);
  }
}

void clearFields(SoNode* node) {
  SoFieldList fields;
  const int count = node->getFields(fields);
  for (int i = 0; i < count; ++i) {
    if (auto* one = dynamic_cast<SoSFNode*>(fields[i]); one && isNurbs(one->getValue())) one->setValue(nullptr);
    if (auto* many = dynamic_cast<SoMFNode*>(fields[i])) {
      for (int k = many->getNum() - 1; k >= 0; --k) {
        if (isNurbs((*many)[k])) many->deleteValues(k, 1);
      }
    }
  }
}

}  // namespace

std::vector<const SoNode*> switchOffTrimmedNurbs(SoNode* root) {
  std::vector<const SoNode*> shapes;
  const std::vector<SoNode*> nodes = writtenNodes(root);
  const bool mayBeTrimmed =
      std::ranges::any_of(nodes, [](const SoNode* node) { return node->isOfType(SoProfile::getClassTypeId()); });
  for (SoNode* node : nodes) {
    if (mayBeTrimmed && isNurbs(node)) shapes.push_back(node);
  }
  if (shapes.empty()) return shapes;
  std::vector<NodeRef<SoNode>> kept;  // a field may be the last that holds one
  for (SoNode* node : nodes) kept.emplace_back(node);
  for (SoNode* node : nodes) {
    clearFields(node);
    if (auto* group = dynamic_cast<SoGroup*>(node)) replaceChildren(group);
  }
  return shapes;
}

}  // namespace haptiv
