#include "scenegraph/reading/graph/VrmlAttribute.h"

#include <Inventor/VRMLnodes/SoVRMLColor.h>
#include <Inventor/VRMLnodes/SoVRMLCoordinate.h>
#include <Inventor/VRMLnodes/SoVRMLNormal.h>
#include <Inventor/VRMLnodes/SoVRMLTextureCoordinate.h>
#include <Inventor/fields/SoMFInt32.h>
#include <Inventor/fields/SoSFBool.h>
#include <Inventor/fields/SoSFNode.h>

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

}  // namespace

std::int64_t vrmlValues(const SoSFNode& node) {
  const SoMField* list = listIn(node.getValue());
  return list ? list->getNum() : 0;
}

Attribute vrmlAttribute(const SoSFNode& node, const SoSFBool& perVertex, const SoMFInt32* index) {
  const bool vertices = perVertex.getValue();
  return {vrmlValues(node), vertices ? Per::vertex : Per::face, vertices || (index && index->getNum() > 0),
          listIn(node.getValue())};
}

Attribute vrmlTexture(const SoSFNode& node) {
  return {vrmlValues(node), Per::vertex, true, listIn(node.getValue())};
}

}  // namespace haptiv
