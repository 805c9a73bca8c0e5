#include "scenegraph/compiling/meshes/MeshSource.h"

#include <Inventor/VRMLnodes/SoVRMLGeometry.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/elements/SoCoordinateElement.h>
#include <Inventor/elements/SoProfileCoordinateElement.h>
#include <Inventor/fields/SoSFBool.h>
#include <Inventor/lists/SoNodeList.h>
#include <Inventor/nodes/SoIndexedNurbsSurface.h>
#include <Inventor/nodes/SoNurbsSurface.h>
#include <Inventor/nodes/SoText3.h>
#include <Inventor/nodes/SoVertexShape.h>

namespace haptiv {
namespace {

/// Spheres, texts and the like are always counter-clockwise; shapes made of coordinates say how they are.
bool isClockwise(const SoNode* shape, const SoCallbackAction& action) {
  if (shape->isOfType(SoVRMLGeometry::getClassTypeId())) {
    const auto* ccw = dynamic_cast<const SoSFBool*>(shape->getField("ccw"));
    return ccw && !ccw->getValue();
  }
  return shape->isOfType(SoVertexShape::getClassTypeId()) && action.getVertexOrdering() == SoShapeHints::CLOCKWISE;
}

}  // namespace

MeshSource MeshSource::of(const SoNode* shape, const SoCallbackAction& action) {
  MeshSource source;
  source.toW = action.getModelMatrix();
  source.isClockwise = haptiv::isClockwise(shape, action);
  source.complexity = action.getComplexity();
  source.complexityType = action.getComplexityType();
  source.faceType = action.getFaceType();
  source.nodes = {shape->getNodeId()};
  SoState* state = action.getState();
  const bool isNurbs =
      shape->isOfType(SoNurbsSurface::getClassTypeId()) || shape->isOfType(SoIndexedNurbsSurface::getClassTypeId());
  if (isNurbs || shape->isOfType(SoVertexShape::getClassTypeId()))
    source.nodes.push_back(SoCoordinateElement::getInstance(state)->getNodeId());
  if (shape->isOfType(SoVertexShape::getClassTypeId()) || shape->isOfType(SoVRMLGeometry::getClassTypeId()))
    return source;
  source.font = action.getFontName();
  source.fontSize = action.getFontSize();
  if (isNurbs || shape->isOfType(SoText3::getClassTypeId())) {
    source.nodes.push_back(SoProfileCoordinateElement::getInstance(state)->getNodeId());
    const SoNodeList& profiles = action.getProfile();
    for (int i = 0; i < profiles.getLength(); ++i) source.nodes.push_back(profiles[i]->getNodeId());
  }
  return source;
}

}  // namespace haptiv
