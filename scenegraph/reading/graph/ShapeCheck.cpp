#include "scenegraph/reading/graph/ShapeCheck.h"

#include <Inventor/VRMLnodes/SoVRMLElevationGrid.h>
#include <Inventor/VRMLnodes/SoVRMLIndexedLine.h>
#include <Inventor/VRMLnodes/SoVRMLIndexedShape.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoIndexedLineSet.h>
#include <Inventor/nodes/SoIndexedShape.h>
#include <Inventor/nodes/SoIndexedTriangleStripSet.h>
#include <Inventor/nodes/SoTriangleStripSet.h>
#include <Inventor/nodes/SoVertexProperty.h>
#include <Inventor/nodes/SoVertexShape.h>

#include <algorithm>
#include <utility>

#include "scenegraph/reading/graph/NurbsRules.h"
#include "scenegraph/reading/graph/VrmlAttribute.h"

namespace haptiv {

bool ShapeCheck::operator()(const SoNode* node, const AttributesInForce& state) {
  isSound_ = true;
  const bool isShape = checkIfShape(node, state);
  if (isShape && isSound_) faults_.noteSound(node);
  return isShape;
}

bool ShapeCheck::checkIfShape(const SoNode* node, const AttributesInForce& state) {
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

void ShapeCheck::checkShape(const SoVertexShape& shape, AttributesInForce state) {
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
  hold(&shape, "texture coordinate", reach, state.textureCoordinates, indexed ? &indexed->textureCoordIndex : nullptr);
  if (!reach.fault.empty()) say(&shape, reach.fault);
}

void ShapeCheck::checkShape(const SoVRMLIndexedShape& shape) {
  const ShapeReach reach = reachOfIndices(shape.coordIndex, false, false);
  hold(&shape, "coordinate", reach.coordinates, vrmlValues(shape.coord));
  holdCrowds(&shape, reach);
  hold(&shape, "normal", reach, vrmlAttribute(shape.normal, shape.normalPerVertex, &shape.normalIndex),
       &shape.normalIndex);
  hold(&shape, "color", reach, vrmlAttribute(shape.color, shape.colorPerVertex, &shape.colorIndex), &shape.colorIndex);
  hold(&shape, "texture coordinate", reach, vrmlTexture(shape.texCoord), &shape.texCoordIndex);
  if (!reach.fault.empty()) say(&shape, reach.fault);
}

void ShapeCheck::checkShape(const SoVRMLIndexedLine& shape) {
  const ShapeReach reach = reachOfIndices(shape.coordIndex, true, false);
  hold(&shape, "coordinate", reach.coordinates, vrmlValues(shape.coord));
  hold(&shape, "color", reach, vrmlAttribute(shape.color, shape.colorPerVertex, &shape.colorIndex), &shape.colorIndex);
  if (!reach.fault.empty()) say(&shape, reach.fault);
}

void ShapeCheck::checkShape(const SoVRMLElevationGrid& grid) {
  const std::int64_t columns = std::max(0, grid.xDimension.getValue());
  const std::int64_t rows = std::max(0, grid.zDimension.getValue());
  ShapeReach reach;
  reach.vertices = columns * rows;
  reach.faces = std::max<std::int64_t>(0, (columns - 1) * (rows - 1));
  hold(&grid, "height", reach.vertices, grid.height.getNum());
  hold(&grid, "normal", reach, vrmlAttribute(grid.normal, grid.normalPerVertex), nullptr);
  hold(&grid, "color", reach, vrmlAttribute(grid.color, grid.colorPerVertex), nullptr);
  hold(&grid, "texture coordinate", reach, vrmlTexture(grid.texCoord), nullptr);
}

void ShapeCheck::hold(const SoNode* node, const char* what, const ShapeReach& reach, const Attribute& attribute,
                      const SoMFInt32* index) {
  if (attribute.count <= 0) return;
  if (reach.lacksIndex(attribute.per, attribute.byIndex, index)) {
    mending_.add(*index, *reach.coordIndex, attribute.count);
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
    mending_.add(attribute.values, needed);
    say(node,
        "reaches for " + std::string(what) + " " + std::to_string(needed - 1) + " (the first is 0), and there are " +
            std::to_string(attribute.count) + ": the last one is repeated",
        Diagnostic::Severity::warning);
  } else {
    hold(node, what, needed, attribute.count);
  }
}

void ShapeCheck::hold(const SoNode* node, const char* what, std::int64_t needed, std::int64_t available) {
  if (needed <= available) return;
  say(node, "reaches for " + std::string(what) + " " + std::to_string(needed - 1) +
                " (the first is 0), and there are " + std::to_string(available) +
                ": correct its indices or counts, or add what is missing");
}

void ShapeCheck::holdCrowds(const SoNode* node, const ShapeReach& reach) {
  if (!isSound_ || !reach.coordIndex || reach.isLines || !reach.fault.empty()) return;
  const std::string fault = crowds_.add(node, *reach.coordIndex);
  if (!fault.empty()) say(node, fault);
}

void ShapeCheck::holdCrowds(const SoVertexShape& shape, const ShapeReach& reach, const AttributesInForce& state) {
  const bool hasFaces =
      shape.isOfType(SoFaceSet::getClassTypeId()) || shape.isOfType(SoTriangleStripSet::getClassTypeId());
  if (!isSound_ || !hasFaces || !reach.fault.empty() || !state.points || state.normals.count > 0) return;
  const std::int64_t first = reach.coordinates - reach.vertices;
  if (first < 0 || reach.coordinates > state.points->getNum()) return;
  const std::string fault = crowds_.add(&shape, *state.points, first, reach.vertices);
  if (!fault.empty()) say(&shape, fault);
}

void ShapeCheck::say(const SoNode* node, std::string message, Diagnostic::Severity severity) {
  if (severity == Diagnostic::Severity::error) isSound_ = false;
  faults_.add(node, std::move(message), severity);
}

}  // namespace haptiv
