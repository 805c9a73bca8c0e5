#include "scenegraph/reading/graph/ShapeIndices.h"

#include <Inventor/VRMLnodes/SoVRMLColor.h>
#include <Inventor/VRMLnodes/SoVRMLCoordinate.h>
#include <Inventor/VRMLnodes/SoVRMLElevationGrid.h>
#include <Inventor/VRMLnodes/SoVRMLIndexedLine.h>
#include <Inventor/VRMLnodes/SoVRMLIndexedShape.h>
#include <Inventor/VRMLnodes/SoVRMLNormal.h>
#include <Inventor/VRMLnodes/SoVRMLScript.h>
#include <Inventor/VRMLnodes/SoVRMLTextureCoordinate.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoIndexedLineSet.h>
#include <Inventor/nodes/SoIndexedShape.h>
#include <Inventor/nodes/SoIndexedTriangleStripSet.h>
#include <Inventor/nodes/SoLOD.h>
#include <Inventor/nodes/SoLevelOfDetail.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTriangleStripSet.h>
#include <Inventor/nodes/SoVertexProperty.h>
#include <Inventor/nodes/SoVertexShape.h>

#include <set>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "scenegraph/GraphWalk.h"
#include "scenegraph/Keyword.h"
#include "scenegraph/reading/graph/AttributesInForce.h"
#include "scenegraph/reading/graph/CrowdedPoints.h"
#include "scenegraph/reading/graph/ListMending.h"
#include "scenegraph/reading/graph/NurbsRules.h"

namespace haptiv {
namespace {

/// The values of a VRML attribute node, of whatever kind; null where there is none.
const SoMField* listIn(const SoNode* node) {
  if (const auto* points = dynamic_cast<const SoVRMLCoordinate*>(node)) return &points->point;
  if (const auto* normals = dynamic_cast<const SoVRMLNormal*>(node)) return &normals->vector;
  if (const auto* colors = dynamic_cast<const SoVRMLColor*>(node)) return &colors->color;
  if (const auto* points = dynamic_cast<const SoVRMLTextureCoordinate*>(node)) return &points->point;
  return nullptr;
}

std::int64_t valuesOf(const SoNode* node) {
  const SoMField* list = listIn(node);
  return list ? list->getNum() : 0;
}

/// Without an index of its own, VRML's attribute of faces goes through them in order.
Attribute vrmlAttribute(const SoSFNode& node, const SoSFBool& perVertex, const SoMFInt32* index = nullptr) {
  const bool vertices = perVertex.getValue();
  return {valuesOf(node.getValue()), vertices ? Per::vertex : Per::face, vertices || (index && index->getNum() > 0),
          listIn(node.getValue())};
}

/// Goes through the graph as actions do. Recursive: expansionFault has bounded the depth.
class IndexChecker {
 public:
  Diagnostics faults;
  ListMending mending;

  void visit(const SoNode* node, AttributesInForce& state) {
    state.update(node);
    isSound_ = true;
    if (checkIfShape(node, state)) {
      if (isSound_) sound_.insert(node);
    } else if (!node->isOfType(SoVRMLScript::getClassTypeId())) {  // its fields only refer to nodes: to itself, perhaps
      visitChildren(node, state);
    }
  }

  /// Many files keep shapes behind a Switch that shows none, and use them elsewhere, after the coordinates: what is
  /// right there may be wrong here.
  void judgeHidden() {
    for (Diagnostic& fault : hidden_) {
      if (!sound_.contains(fault.source)) faults.push_back(std::move(fault));
    }
  }

 private:
  bool checkIfShape(const SoNode* node, const AttributesInForce& state) {
    if (const auto* shape = dynamic_cast<const SoVertexShape*>(node)) {
      checkShape(*shape, state);
    } else if (const auto* vrml = dynamic_cast<const SoVRMLIndexedShape*>(node)) {
      checkShape(*vrml);
    } else if (const auto* lines = dynamic_cast<const SoVRMLIndexedLine*>(node)) {
      checkShape(*lines);
    } else if (const auto* grid = dynamic_cast<const SoVRMLElevationGrid*>(node)) {
      checkShape(*grid);
    } else if (isNurbs(node)) {
      const std::string fault = nurbsFault(node, state);
      if (!fault.empty()) say(node, fault);
    } else {
      return false;
    }
    return true;
  }

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
      const bool wasHidden = std::exchange(isHidden_, isHidden_ || (!isChosen && !canChange));
      visit(children[i], isChosen ? state : aside);
      isHidden_ = wasHidden;
    }
    const bool leaks = node->isOfType(SoGroup::getClassTypeId()) && !node->isOfType(SoSeparator::getClassTypeId());
    if (!leaks) state = before;
  }

  void checkShape(const SoVertexShape& shape, AttributesInForce state) {
    if (const SoNode* own = shape.vertexProperty.getValue()) state.update(own);
    const auto* indexed = dynamic_cast<const SoIndexedShape*>(&shape);
    ShapeReach reach;
    if (!indexed) {
      reach = reachOfCounts(&shape, state.coordinates);
    } else if (!indexed->coordIndex.isDefault()) {
      reach = reachOfIndices(indexed->coordIndex, dynamic_cast<const SoIndexedLineSet*>(&shape),
                             dynamic_cast<const SoIndexedTriangleStripSet*>(&shape));
    }
    hold(&shape, "coordinate", reach.coordinates, state.coordinates);
    holdCrowds(&shape, reach);
    if (!indexed) holdCrowds(shape, reach, state);
    hold(&shape, "normal", reach, state.normals, indexed ? &indexed->normalIndex : nullptr);
    hold(&shape, "material", reach, state.materials, indexed ? &indexed->materialIndex : nullptr);
    hold(&shape, "texture coordinate", reach, state.textureCoordinates,
         indexed ? &indexed->textureCoordIndex : nullptr);
    if (!reach.fault.empty()) say(&shape, reach.fault);
  }

  void checkShape(const SoVRMLIndexedShape& shape) {
    const ShapeReach reach = reachOfIndices(shape.coordIndex, false, false);
    hold(&shape, "coordinate", reach.coordinates, valuesOf(shape.coord.getValue()));
    holdCrowds(&shape, reach);
    hold(&shape, "normal", reach, vrmlAttribute(shape.normal, shape.normalPerVertex, &shape.normalIndex),
         &shape.normalIndex);
    hold(&shape, "color", reach, vrmlAttribute(shape.color, shape.colorPerVertex, &shape.colorIndex),
         &shape.colorIndex);
    const Attribute texture{valuesOf(shape.texCoord.getValue()), Per::vertex, true, listIn(shape.texCoord.getValue())};
    hold(&shape, "texture coordinate", reach, texture, &shape.texCoordIndex);
    if (!reach.fault.empty()) say(&shape, reach.fault);
  }

  void checkShape(const SoVRMLIndexedLine& shape) {
    const ShapeReach reach = reachOfIndices(shape.coordIndex, true, false);
    hold(&shape, "coordinate", reach.coordinates, valuesOf(shape.coord.getValue()));
    hold(&shape, "color", reach, vrmlAttribute(shape.color, shape.colorPerVertex, &shape.colorIndex),
         &shape.colorIndex);
    if (!reach.fault.empty()) say(&shape, reach.fault);
  }

  void checkShape(const SoVRMLElevationGrid& grid) {
    const std::int64_t columns = std::max(0, grid.xDimension.getValue());
    const std::int64_t rows = std::max(0, grid.zDimension.getValue());
    ShapeReach reach;
    reach.vertices = columns * rows;
    reach.faces = std::max<std::int64_t>(0, (columns - 1) * (rows - 1));
    hold(&grid, "height", reach.vertices, grid.height.getNum());
    hold(&grid, "normal", reach, vrmlAttribute(grid.normal, grid.normalPerVertex), nullptr);
    hold(&grid, "color", reach, vrmlAttribute(grid.color, grid.colorPerVertex), nullptr);
    hold(&grid, "texture coordinate", reach,
         {valuesOf(grid.texCoord.getValue()), Per::vertex, true, listIn(grid.texCoord.getValue())}, nullptr);
  }

  /// An attribute without any value is made by Coin itself.
  void hold(const SoNode* node, const char* what, const ShapeReach& reach, const Attribute& attribute,
            const SoMFInt32* index) {
    if (attribute.count <= 0) return;
    if (reach.lacksIndex(attribute.per, attribute.byIndex, index)) {
      mending.add(*index, *reach.coordIndex, attribute.count);
      return say(node,
                 "its list of " + std::string(what) +
                     "s has no index, which its binding asks for: that of its coordinates is taken",
                 Diagnostic::Severity::warning);
    }
    const std::int64_t needed = reach.of(attribute.per, attribute.byIndex, index);
    const std::string fault = reach.indexFault(attribute.per, attribute.byIndex, index);
    if (!fault.empty()) {
      say(node, "its list of " + std::string(what) + "s " + fault);
    } else if (needed > attribute.count && ListMending::isWorthIt(needed, attribute.count)) {
      mending.add(attribute.values, needed);
      say(node,
          "reaches for " + std::string(what) + " " + std::to_string(needed - 1) + " (the first is 0), and there are " +
              std::to_string(attribute.count) + ": the last one is repeated",
          Diagnostic::Severity::warning);
    } else {
      hold(node, what, needed, attribute.count);
    }
  }

  void hold(const SoNode* node, const char* what, std::int64_t needed, std::int64_t available) {
    if (needed <= available) return;
    say(node, "reaches for " + std::string(what) + " " + std::to_string(needed - 1) +
                  " (the first is 0), and there are " + std::to_string(available) +
                  ": correct its indices or counts, or add what is missing");
  }

  void holdCrowds(const SoNode* node, const ShapeReach& reach) {
    if (!isSound_ || !reach.coordIndex || reach.isLines || !reach.fault.empty()) return;
    const std::string fault = crowds_.add(node, *reach.coordIndex);
    if (!fault.empty()) say(node, fault);
  }

  /// Of a shape without indices; where it has normals, Coin makes none.
  void holdCrowds(const SoVertexShape& shape, const ShapeReach& reach, const AttributesInForce& state) {
    const bool hasFaces =
        shape.isOfType(SoFaceSet::getClassTypeId()) || shape.isOfType(SoTriangleStripSet::getClassTypeId());
    if (!isSound_ || !hasFaces || !reach.fault.empty() || !state.points || state.normals.count > 0) return;
    const std::int64_t first = reach.coordinates - reach.vertices;
    if (first < 0 || reach.coordinates > state.points->getNum()) return;
    const std::string fault = crowds_.add(&shape, *state.points, first, reach.vertices);
    if (!fault.empty()) say(&shape, fault);
  }

  void say(const SoNode* node, std::string message, Diagnostic::Severity severity = Diagnostic::Severity::error) {
    const bool isError = severity == Diagnostic::Severity::error;
    if (isError) isSound_ = false;
    if (!said_.emplace(node, severity, isHidden_).second) return;
    (isError && isHidden_ ? hidden_ : faults).push_back({severity, {}, 0, describe(node), std::move(message), node});
  }

  bool isHidden_ = false;  ///< behind a Switch
  bool isSound_ = true;    ///< the shape that is being checked, so far
  CrowdedPoints crowds_;
  Diagnostics hidden_;
  std::unordered_set<const SoNode*> sound_;  ///< shapes that are right in one place at least
  std::set<std::tuple<const SoNode*, Diagnostic::Severity, bool>> said_;
};

}  // namespace

Diagnostics shapeIndexFaults(SoNode* root) {
  IndexChecker checker;
  AttributesInForce state;
  checker.visit(root, state);
  checker.judgeHidden();
  if (!hasErrors(checker.faults)) checker.mending.mend(root);
  return std::move(checker.faults);
}

}  // namespace haptiv
