#include "scenegraph/ShapeIndices.h"

#include <Inventor/VRMLnodes/SoVRMLCoordinate.h>
#include <Inventor/VRMLnodes/SoVRMLElevationGrid.h>
#include <Inventor/VRMLnodes/SoVRMLIndexedFaceSet.h>
#include <Inventor/VRMLnodes/SoVRMLIndexedLineSet.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoCoordinate4.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoIndexedShape.h>
#include <Inventor/nodes/SoLOD.h>
#include <Inventor/nodes/SoLevelOfDetail.h>
#include <Inventor/nodes/SoLineSet.h>
#include <Inventor/nodes/SoPointSet.h>
#include <Inventor/nodes/SoQuadMesh.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTriangleStripSet.h>
#include <Inventor/nodes/SoVertexProperty.h>

#include <algorithm>
#include <cstdint>
#include <set>

#include "scenegraph/GraphWalk.h"
#include "scenegraph/Keyword.h"

namespace haptiv {
namespace {

/// How many coordinates a shape reaches for: one more than its largest index.
std::int64_t reachOf(const SoMFInt32& indices) {
  const int32_t* values = indices.getValues(0);
  const auto* largest = std::max_element(values, values + indices.getNum());
  return indices.getNum() > 0 ? std::int64_t{*largest} + 1 : 0;
}

/// Of shapes that take coordinates in their order; -1 stands for all the rest.
std::int64_t reachOf(std::int64_t start, const SoMFInt32& counts) {
  std::int64_t reach = start;
  for (int i = 0; i < counts.getNum(); ++i) {
    if (counts[i] > 0) reach += counts[i];
  }
  return reach;
}

std::int64_t reachOf(const SoNode* node) {
  if (const auto* indexed = dynamic_cast<const SoIndexedShape*>(node)) {
    return indexed->coordIndex.isDefault() ? 0 : reachOf(indexed->coordIndex);
  }
  const auto* plain = dynamic_cast<const SoNonIndexedShape*>(node);
  if (!plain) return 0;
  const std::int64_t start = plain->startIndex.getValue();
  if (const auto* faces = dynamic_cast<const SoFaceSet*>(node)) return reachOf(start, faces->numVertices);
  if (const auto* strips = dynamic_cast<const SoTriangleStripSet*>(node)) return reachOf(start, strips->numVertices);
  if (const auto* lines = dynamic_cast<const SoLineSet*>(node)) return reachOf(start, lines->numVertices);
  if (const auto* points = dynamic_cast<const SoPointSet*>(node))
    return start + std::max(0, points->numPoints.getValue());
  if (const auto* mesh = dynamic_cast<const SoQuadMesh*>(node)) {
    return start + std::int64_t{mesh->verticesPerRow.getValue()} * mesh->verticesPerColumn.getValue();
  }
  return 0;
}

/// Goes through the graph as actions do, remembering how many coordinates are in force. Recursive: expansionFault has
/// bounded the depth.
class Checker {
 public:
  Diagnostics faults;

  /// @return how many coordinates are in force after the node
  std::int64_t visit(const SoNode* node, std::int64_t coordinates) {
    if (const auto* points = dynamic_cast<const SoCoordinate3*>(node)) return points->point.getNum();
    if (const auto* points = dynamic_cast<const SoCoordinate4*>(node)) return points->point.getNum();
    if (const auto* vertices = dynamic_cast<const SoVertexProperty*>(node)) {
      return vertices->vertex.getNum() > 0 ? vertices->vertex.getNum() : coordinates;
    }
    checkShape(node, coordinates);
    return visitChildren(node, coordinates);
  }

 private:
  std::int64_t visitChildren(const SoNode* node, std::int64_t before) {
    const auto children = writtenChildren(node);
    const auto* choice = dynamic_cast<const SoSwitch*>(node);
    const bool isLevels = dynamic_cast<const SoLOD*>(node) || dynamic_cast<const SoLevelOfDetail*>(node);
    const bool all = (!choice && !isLevels) || (choice && choice->whichChild.getValue() == SO_SWITCH_ALL);
    const int chosen = choice ? choice->whichChild.getValue() : 0;
    std::int64_t after = before;
    for (std::size_t i = 0; i < children.size(); ++i) {
      const std::int64_t result = visit(children[i], all ? after : before);
      if (all || static_cast<int>(i) == chosen) after = result;
    }
    return node->isOfType(SoSeparator::getClassTypeId()) || !node->isOfType(SoGroup::getClassTypeId()) ? before : after;
  }

  void checkShape(const SoNode* node, std::int64_t coordinates) {
    if (const auto* shape = dynamic_cast<const SoVertexShape*>(node)) {
      const auto* own = dynamic_cast<const SoVertexProperty*>(shape->vertexProperty.getValue());
      if (own && own->vertex.getNum() > 0) coordinates = own->vertex.getNum();
      hold(node, reachOf(node), coordinates);
    } else if (const auto* faces = dynamic_cast<const SoVRMLIndexedShape*>(node)) {
      hold(node, reachOf(faces->coordIndex), pointsOf(faces->coord.getValue()));
    } else if (const auto* lines = dynamic_cast<const SoVRMLIndexedLine*>(node)) {
      hold(node, reachOf(lines->coordIndex), pointsOf(lines->coord.getValue()));
    } else if (const auto* grid = dynamic_cast<const SoVRMLElevationGrid*>(node)) {
      const std::int64_t heights = std::int64_t{grid->xDimension.getValue()} * grid->zDimension.getValue();
      hold(node, heights, grid->height.getNum());
    }
  }

  static std::int64_t pointsOf(const SoNode* node) {
    const auto* coordinates = dynamic_cast<const SoVRMLCoordinate*>(node);
    return coordinates ? coordinates->point.getNum() : 0;
  }

  void hold(const SoNode* node, std::int64_t reach, std::int64_t coordinates) {
    if (reach <= coordinates || !said_.insert(node).second) return;
    faults.push_back({Diagnostic::Severity::error,
                      {},
                      0,
                      describe(node),
                      "reaches for coordinate " + std::to_string(reach - 1) + " (the first is 0), and there are " +
                          std::to_string(coordinates) + ": correct its indices or counts, or add coordinates",
                      node});
  }

  std::set<const SoNode*> said_;
};

}  // namespace

Diagnostics shapeIndexFaults(SoNode* root) {
  Checker checker;
  checker.visit(root, 0);
  return std::move(checker.faults);
}

}  // namespace haptiv
