#include "scenegraph/reading/graph/NurbsSwitch.h"

#include <Inventor/fields/SoMFNode.h>
#include <Inventor/fields/SoSFNode.h>
#include <Inventor/lists/SoFieldList.h>
#include <Inventor/nodes/SoGroup.h>
#include <Inventor/nodes/SoIndexedNurbsCurve.h>
#include <Inventor/nodes/SoIndexedNurbsSurface.h>
#include <Inventor/nodes/SoNurbsCurve.h>
#include <Inventor/nodes/SoNurbsSurface.h>
#include <Inventor/nodes/SoSwitch.h>

#include "scenegraph/NodeRef.h"
#include "scenegraph/reading/graph/GraphWalk.h"

namespace haptiv {
namespace {

bool isNurbs(const SoNode* node) {
  for (const SoType type : {SoNurbsSurface::getClassTypeId(), SoIndexedNurbsSurface::getClassTypeId(),
                            SoNurbsCurve::getClassTypeId(), SoIndexedNurbsCurve::getClassTypeId()}) {
    if (node && node->isOfType(type)) return true;
  }
  return false;
}

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

std::vector<const SoNode*> switchOffNurbs(SoNode* root) {
  std::vector<const SoNode*> shapes;
  const std::vector<SoNode*> nodes = writtenNodes(root);
  for (SoNode* node : nodes) {
    if (isNurbs(node)) shapes.push_back(node);
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
