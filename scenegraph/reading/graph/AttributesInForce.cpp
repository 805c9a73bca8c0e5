#include "scenegraph/reading/graph/AttributesInForce.h"

#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoCoordinate4.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoMaterialBinding.h>
#include <Inventor/nodes/SoNormal.h>
#include <Inventor/nodes/SoNormalBinding.h>
#include <Inventor/nodes/SoPackedColor.h>
#include <Inventor/nodes/SoTextureCoordinate2.h>
#include <Inventor/nodes/SoTextureCoordinate3.h>
#include <Inventor/nodes/SoTextureCoordinateBinding.h>
#include <Inventor/nodes/SoVertexProperty.h>

namespace haptiv {
namespace {

/// The values of the three binding nodes' enumerations agree, as far as each goes.
void bind(Attribute& attribute, int binding) {
  using Binding = SoMaterialBinding;
  attribute.byIndex = binding == Binding::PER_PART_INDEXED || binding == Binding::PER_FACE_INDEXED ||
                      binding == Binding::PER_VERTEX_INDEXED;
  switch (binding) {
    case Binding::PER_PART:
    case Binding::PER_PART_INDEXED:
      attribute.per = Per::part;
      break;
    case Binding::PER_FACE:
    case Binding::PER_FACE_INDEXED:
      attribute.per = Per::face;
      break;
    case Binding::PER_VERTEX:
    case Binding::PER_VERTEX_INDEXED:
      attribute.per = Per::vertex;
      break;
    default:
      attribute.per = Per::shape;
  }
}

void take(Attribute& attribute, const SoMField& values) {
  attribute.count = values.getNum();
  attribute.values = &values;
}

void takeIfAny(Attribute& attribute, const SoMField& values) {
  if (values.getNum() > 0) take(attribute, values);
}

void takeVertices(AttributesInForce& state, const SoVertexProperty& node) {
  if (node.vertex.getNum() > 0) {  // an empty list leaves what was in force
    state.coordinates = node.vertex.getNum();
    state.points = &node.vertex;
  }
  takeIfAny(state.textureCoordinates, node.texCoord.getNum() > node.texCoord3.getNum()
                                          ? static_cast<const SoMField&>(node.texCoord)
                                          : node.texCoord3);
  if (node.normal.getNum() > 0) {
    take(state.normals, node.normal);
    bind(state.normals, node.normalBinding.getValue());
  }
  if (node.orderedRGBA.getNum() > 0) {
    take(state.materials, node.orderedRGBA);
    bind(state.materials, node.materialBinding.getValue());
  }
}

}  // namespace

void AttributesInForce::update(const SoNode* node) {
  if (const auto* three = dynamic_cast<const SoCoordinate3*>(node)) {
    coordinates = three->point.getNum();
    points = &three->point;
  } else if (const auto* four = dynamic_cast<const SoCoordinate4*>(node)) {
    coordinates = four->point.getNum();
    points = nullptr;
  } else if (const auto* normal = dynamic_cast<const SoNormal*>(node)) {
    take(normals, normal->vector);
  } else if (const auto* material = dynamic_cast<const SoMaterial*>(node)) {
    takeIfAny(materials, material->diffuseColor);
  } else if (const auto* base = dynamic_cast<const SoBaseColor*>(node)) {
    takeIfAny(materials, base->rgb);
  } else if (const auto* packed = dynamic_cast<const SoPackedColor*>(node)) {
    takeIfAny(materials, packed->orderedRGBA);
  } else if (const auto* texture2 = dynamic_cast<const SoTextureCoordinate2*>(node)) {
    take(textureCoordinates, texture2->point);
  } else if (const auto* texture3 = dynamic_cast<const SoTextureCoordinate3*>(node)) {
    take(textureCoordinates, texture3->point);
  } else if (const auto* normalBinding = dynamic_cast<const SoNormalBinding*>(node)) {
    bind(normals, normalBinding->value.getValue());
  } else if (const auto* materialBinding = dynamic_cast<const SoMaterialBinding*>(node)) {
    bind(materials, materialBinding->value.getValue());
  } else if (const auto* textureBinding = dynamic_cast<const SoTextureCoordinateBinding*>(node)) {
    textureCoordinates.byIndex = textureBinding->value.getValue() == SoTextureCoordinateBinding::PER_VERTEX_INDEXED;
  } else if (const auto* vertices = dynamic_cast<const SoVertexProperty*>(node)) {
    takeVertices(*this, *vertices);
  }
}

}  // namespace haptiv
