#include "scenegraph/reading/graph/GraphWalk.h"

#include <Inventor/VRMLnodes/SoVRMLExtrusion.h>
#include <Inventor/VRMLnodes/SoVRMLScript.h>
#include <Inventor/fields/SoMFNode.h>
#include <Inventor/fields/SoMFString.h>
#include <Inventor/fields/SoMField.h>
#include <Inventor/fields/SoSFNode.h>
#include <Inventor/lists/SoFieldList.h>
#include <Inventor/misc/SoChildList.h>
#include <Inventor/nodes/SoArray.h>
#include <Inventor/nodes/SoGroup.h>
#include <Inventor/nodes/SoMultipleCopy.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace haptiv {
namespace {

constexpr double kMaxCost = 5e7;     // about a million triangles a second and some seconds to go through it
constexpr double kNodeCost = 16;     // a visited node costs about as much as so many visited values
constexpr double kQuadCost = 32;     // two triangles, and their normals, which are made from all around
constexpr int kDeepestGraph = 1000;  // actions recurse, and USE makes a graph deeper than its text

std::vector<SoNode*> nodesInFields(const SoNode* node) {
  std::vector<SoNode*> nodes;
  SoFieldList fields;
  const int count = node->getFields(fields);
  for (int i = 0; i < count; ++i) {
    if (const auto* one = dynamic_cast<const SoSFNode*>(fields[i])) nodes.push_back(one->getValue());
    if (const auto* many = dynamic_cast<const SoMFNode*>(fields[i])) {
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

/// What actions visit: hidden children too.
std::vector<SoNode*> traversedChildren(const SoNode* node) {
  if (node->isOfType(SoVRMLScript::getClassTypeId())) return {};  // its fields only refer to nodes
  const SoChildList* children = node->getChildren();
  return children && children->getLength() > 0 ? listed(*children) : nodesInFields(node);
}

/// A letter may be drawn with some dozens of triangles.
double letterCost(const SoMFString& strings) {
  double letters = 0;
  for (int i = 0; i < strings.getNum(); ++i) letters += strings[i].getLength();
  return 64 * letters;
}

double timesTraversed(const SoNode* node) {
  if (const auto* array = dynamic_cast<const SoArray*>(node)) {
    const auto times = [](const SoSFShort& n) { return std::max(1.0, static_cast<double>(n.getValue())); };
    return times(array->numElements1) * times(array->numElements2) * times(array->numElements3);
  }
  if (const auto* copies = dynamic_cast<const SoMultipleCopy*>(node)) return std::max(1, copies->matrix.getNum());
  return 1;
}

double ownCost(const SoNode* node) {
  double cost = kNodeCost * timesTraversed(node);  // an array is gone through even where there is nothing in it
  SoFieldList fields;
  const int count = node->getFields(fields);
  for (int i = 0; i < count; ++i) {
    if (const auto* values = dynamic_cast<const SoMField*>(fields[i])) cost += values->getNum();
    if (const auto* strings = dynamic_cast<const SoMFString*>(fields[i])) cost += letterCost(*strings);
  }
  if (const auto* extrusion = dynamic_cast<const SoVRMLExtrusion*>(node))
    cost += kQuadCost * static_cast<double>(extrusion->crossSection.getNum()) * extrusion->spine.getNum();
  return cost;
}

/// What visiting a node, and all below it, comes to.
struct Extent {
  bool open = true;  ///< it is being looked at: met again, it stands inside itself
  double cost = 0;
  int depth = 1;
};

struct Visit {
  SoNode* node;
  std::vector<SoNode*> children;
  std::size_t next = 0;
};

}  // namespace

std::vector<SoNode*> writtenChildren(const SoNode* node) {
  if (!node->isOfType(SoGroup::getClassTypeId())) return nodesInFields(node);
  return listed(*node->getChildren());
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

GraphFault expansionFault(SoNode* root) {
  std::unordered_map<const SoNode*, Extent> extents;
  std::vector<Visit> stack;
  const auto enter = [&](SoNode* node) {
    extents[node].cost = ownCost(node);
    stack.push_back({node, traversedChildren(node)});
  };
  enter(root);
  while (!stack.empty()) {
    Visit& visit = stack.back();
    Extent& extent = extents[visit.node];
    if (extent.cost > kMaxCost) {
      return {"the scene becomes too large once every USE, array and shape is written out: use fewer copies",
              visit.node};
    }
    if (visit.next == visit.children.size()) {
      extent.open = false;
      stack.pop_back();
      continue;
    }
    SoNode* child = visit.children[visit.next];
    const auto known = extents.find(child);
    if (known == extents.end()) {
      enter(child);
      continue;
    }
    if (known->second.open) return {"stands inside itself: remove the USE that puts it there", child};
    ++visit.next;
    extent.cost += timesTraversed(visit.node) * known->second.cost;
    extent.depth = std::max(extent.depth, known->second.depth + 1);
    if (extent.depth > kDeepestGraph)
      return {"USE nests the scene deeper than 1000 levels: make it flatter", visit.node};
  }
  return {};
}

}  // namespace haptiv
