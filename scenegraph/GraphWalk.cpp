#include "scenegraph/GraphWalk.h"

#include <Inventor/VRMLnodes/SoVRMLScript.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/fields/SoMFNode.h>
#include <Inventor/fields/SoSFNode.h>
#include <Inventor/lists/SoFieldList.h>
#include <Inventor/misc/SoChildList.h>
#include <Inventor/nodes/SoGroup.h>

#include <algorithm>
#include <unordered_set>

namespace haptiv {
namespace {

std::vector<SoNode*> nodesInFields(const SoNode* node) {
  std::vector<SoNode*> nodes;
  for (const SoField* field : fieldsOf(node)) {
    if (const auto* one = dynamic_cast<const SoSFNode*>(field)) nodes.push_back(one->getValue());
    if (const auto* many = dynamic_cast<const SoMFNode*>(field)) {
      for (int k = 0; k < many->getNum(); ++k) nodes.push_back((*many)[k]);
    }
  }
  std::erase(nodes, nullptr);
  return nodes;
}

std::vector<SoNode*> listed(const SoChildList& list) {
  std::vector<SoNode*> nodes;
  for (int i = 0; i < list.getLength(); ++i) nodes.push_back(list[i]);
  return nodes;
}

}  // namespace

std::vector<SoField*> fieldsOf(const SoFieldContainer* container) {
  SoFieldList list;
  const int count = container->getFields(list);
  std::vector<SoField*> fields;
  for (int i = 0; i < count; ++i) fields.push_back(list[i]);
  return fields;
}

std::vector<SoNode*> writtenChildren(const SoNode* node) {
  if (!node->isOfType(SoGroup::getClassTypeId())) return nodesInFields(node);
  return listed(*node->getChildren());
}

std::vector<SoNode*> traversedChildren(const SoNode* node) {
  if (node->isOfType(SoVRMLScript::getClassTypeId())) return {};  // its fields only refer to nodes
  const SoChildList* children = node->getChildren();
  return children && children->getLength() > 0 ? listed(*children) : nodesInFields(node);
}

std::vector<SoNode*> writtenNodes(SoNode* root) {
  std::vector<SoNode*> order;
  std::unordered_set<const SoNode*> seen;
  std::vector<SoNode*> waiting = {root};
  while (!waiting.empty()) {
    SoNode* node = waiting.back();
    waiting.pop_back();
    if (!seen.insert(node).second) continue;
    order.push_back(node);
    const auto children = writtenChildren(node);
    waiting.insert(waiting.end(), children.rbegin(), children.rend());
  }
  return order;
}

std::size_t drawnTriangles(SoNode* root) {
  SoGetPrimitiveCountAction count;
  count.apply(root);
  return static_cast<std::size_t>(std::max(0, count.getTriangleCount()));
}

}  // namespace haptiv
