#include "scenegraph/compiling/PlainSeparator.h"

#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoCone.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoCylinder.h>
#include <Inventor/nodes/SoInfo.h>
#include <Inventor/nodes/SoLabel.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoRotation.h>
#include <Inventor/nodes/SoScale.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSphere.h>
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTranslation.h>

#include <utility>

#include "scenegraph/compiling/ShapeConversion.h"
#include "scenegraph/nodes/SoHapticNone.h"
#include "scenegraph/nodes/SoHapticRubberBand.h"
#include "scenegraph/nodes/SoHapticSpringZone.h"
#include "scenegraph/nodes/SoHapticSurface.h"
#include "scenegraph/nodes/SoHapticViscousZone.h"

namespace haptiv {
namespace {

enum class PlainKind : unsigned char { other, look, property, shape, translation, rotation, scale, transform };

/// By the numbers that Coin gives its types.
std::vector<PlainKind> allPlainKinds() {
  std::vector<PlainKind> kinds(static_cast<std::size_t>(SoType::getNumTypes()), PlainKind::other);
  const auto say = [&](PlainKind kind, std::initializer_list<SoType> types) {
    for (const SoType type : types) kinds[static_cast<std::size_t>(type.getKey())] = kind;
  };
  say(PlainKind::look, {SoMaterial::getClassTypeId(), SoBaseColor::getClassTypeId(), SoLabel::getClassTypeId(),
                        SoInfo::getClassTypeId()});
  say(PlainKind::property,
      {SoHapticSurface::getClassTypeId(), SoHapticViscousZone::getClassTypeId(), SoHapticSpringZone::getClassTypeId(),
       SoHapticRubberBand::getClassTypeId(), SoHapticNone::getClassTypeId()});
  say(PlainKind::shape,
      {SoCube::getClassTypeId(), SoSphere::getClassTypeId(), SoCylinder::getClassTypeId(), SoCone::getClassTypeId()});
  say(PlainKind::translation, {SoTranslation::getClassTypeId()});
  say(PlainKind::rotation, {SoRotation::getClassTypeId()});
  say(PlainKind::scale, {SoScale::getClassTypeId()});
  say(PlainKind::transform, {SoTransform::getClassTypeId()});
  return kinds;
}

PlainKind plainKindOf(const SoNode* node) {
  static const std::vector<PlainKind> kinds = allPlainKinds();
  const auto key = static_cast<std::size_t>(node->getTypeId().getKey());
  return key < kinds.size() ? kinds[key] : PlainKind::other;
}

/// Multiplies as Coin does. False: a field is set to be ignored, which is left to Coin.
bool placeBy(const SoNode* node, PlainKind kind, SbMatrix& toW) {
  SbMatrix own;
  if (kind == PlainKind::translation) {
    const auto& translation = static_cast<const SoTranslation*>(node)->translation;
    if (translation.isIgnored()) return false;
    own.setTranslate(translation.getValue());
  } else if (kind == PlainKind::rotation) {
    const auto& rotation = static_cast<const SoRotation*>(node)->rotation;
    if (rotation.isIgnored()) return false;
    own.setRotate(rotation.getValue());
  } else if (kind == PlainKind::scale) {
    const auto& factor = static_cast<const SoScale*>(node)->scaleFactor;
    if (factor.isIgnored()) return false;
    own.setScale(factor.getValue());
  } else {
    const auto& t = *static_cast<const SoTransform*>(node);
    if (t.translation.isIgnored() || t.rotation.isIgnored() || t.scaleFactor.isIgnored() ||
        t.scaleOrientation.isIgnored() || t.center.isIgnored())
      return false;
    own.setTransform(t.translation.getValue(), t.rotation.getValue(), t.scaleFactor.getValue(),
                     t.scaleOrientation.getValue(), t.center.getValue());
  }
  toW.multLeft(own);
  return true;
}

}  // namespace

bool PlainSeparator::read(const SoSeparator& separator, const SbMatrix& toW, const SoHapticProperty* property) {
  felt_.clear();
  properties_.clear();
  SbMatrix here = toW;
  for (int i = 0; i < separator.getNumChildren(); ++i) {
    const SoNode* node = separator.getChild(i);
    const PlainKind kind = plainKindOf(node);
    if (kind == PlainKind::other) return false;
    if (kind == PlainKind::look) continue;
    if (kind == PlainKind::property) {
      property = static_cast<const SoHapticProperty*>(node);
      properties_.push_back(property);
    } else if (kind != PlainKind::shape) {
      if (!placeBy(node, kind, here)) return false;
    } else if (property && property->isFelt()) {
      ConvertedShape converted = convertShape(node, here);
      if (!converted.shape) return false;
      felt_.push_back({node, property, here, std::move(*converted.shape)});
    }
  }
  return true;
}

}  // namespace haptiv
