#include "scenegraph/reading/graph/GraphExpansion.h"

#include <Inventor/VRMLnodes/SoVRMLExtrusion.h>
#include <Inventor/fields/SoMFString.h>
#include <Inventor/fields/SoMField.h>
#include <Inventor/nodes/SoArray.h>
#include <Inventor/nodes/SoMultipleCopy.h>

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "scenegraph/GraphWalk.h"

namespace haptiv {
namespace {

constexpr double kMaxCost = 5e7;     // about a million triangles a second and some seconds to go through it
constexpr double kNodeCost = 16;     // a visited node costs about as much as so many visited values
constexpr double kQuadCost = 32;     // two triangles, and their normals, which are made from all around
constexpr int kDeepestGraph = 1000;  // actions recurse, and USE makes a graph deeper than its text

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
  for (const SoField* field : fieldsOf(node)) {
    if (const auto* values = dynamic_cast<const SoMField*>(field)) cost += values->getNum();
    if (const auto* strings = dynamic_cast<const SoMFString*>(field)) cost += letterCost(*strings);
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
