#include "app/editor/items/NodeRoles.h"

#include <Inventor/VRMLnodes/SoVRMLShape.h>
#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShape.h>

#include "scenegraph/nodes/SoHapticDevice.h"
#include "scenegraph/nodes/SoHapticProperty.h"
#include "scenegraph/nodes/SoHapticTool.h"

namespace haptiv {
namespace {

Role roleOfType(SoType type) {
  const auto is = [&](SoType wanted) { return type.isDerivedFrom(wanted); };
  if (is(SoHapticProperty::getClassTypeId())) return Role::property;
  if (is(SoHapticTool::getClassTypeId())) return Role::tool;
  if (is(SoHapticDevice::getClassTypeId())) return Role::device;
  if (is(SoMaterial::getClassTypeId())) return Role::material;
  if (is(SoBaseColor::getClassTypeId())) return Role::baseColor;
  if (is(SoShape::getClassTypeId()) || is(SoVRMLShape::getClassTypeId())) return Role::shape;
  if (type == SoSeparator::getClassTypeId()) return Role::separator;
  return is(SoGroup::getClassTypeId()) ? Role::group : Role::other;
}

}  // namespace

Role NodeRoles::operator()(const SoNode& node) {
  const SoType type = node.getTypeId();
  const auto key = static_cast<std::size_t>(type.getKey());
  if (key >= known_.size()) known_.resize(key + 1, Role::unknown);
  if (known_[key] == Role::unknown) known_[key] = roleOfType(type);
  return known_[key];
}

}  // namespace haptiv
