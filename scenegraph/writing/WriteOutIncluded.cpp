#include "scenegraph/writing/WriteOutIncluded.h"

#include <Inventor/misc/SoChildList.h>
#include <Inventor/nodes/SoGroup.h>
#include <Inventor/nodes/SoSeparator.h>

#include <unordered_set>
#include <vector>

#include "scenegraph/reading/files/NamedFields.h"

namespace haptiv {
namespace {

bool isIncluding(SoNode* node) {
  const SoChildList* children = node->getChildren();
  return children && children->getLength() > 0 && namedFields(node).use == NamedFields::Use::scene;
}

/// All nodes that are traversed, once each.
template <typename Visit>
void forEachNode(SoNode* root, const Visit& visit) {
  std::vector<SoNode*> waiting = {root};
  std::unordered_set<SoNode*> seen = {root};
  while (!waiting.empty()) {
    SoNode* node = waiting.back();
    waiting.pop_back();
    visit(node);
    const SoChildList* children = node->getChildren();
    for (int i = 0; children && i < children->getLength(); ++i) {
      if (seen.insert((*children)[i]).second) waiting.push_back((*children)[i]);
    }
  }
}

SoGroup* groupOf(const SoChildList& children) {
  auto* group = new SoGroup;
  for (int i = 0; i < children.getLength(); ++i) group->addChild(children[i]);
  return group;
}

}  // namespace

bool includesFiles(SoSeparator* root) {
  bool includes = false;
  forEachNode(root, [&](SoNode* node) { includes = includes || isIncluding(node); });
  return includes;
}

void writeOutIncluded(SoSeparator* root) {
  forEachNode(root, [](SoNode* node) {
    if (!node->isOfType(SoGroup::getClassTypeId())) return;
    auto* group = static_cast<SoGroup*>(node);
    for (int i = 0; i < group->getNumChildren(); ++i) {
      SoNode* child = group->getChild(i);
      if (isIncluding(child)) group->replaceChild(i, groupOf(*child->getChildren()));
    }
  });
}

}  // namespace haptiv
