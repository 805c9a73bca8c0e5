#include "scenegraph/compiling/PropertyChecks.h"

#include <cmath>

#include "scenegraph/NumberText.h"
#include "scenegraph/nodes/SoHapticDevice.h"
#include "scenegraph/nodes/SoHapticSpringZone.h"
#include "scenegraph/nodes/SoHapticSurface.h"
#include "scenegraph/nodes/SoHapticTool.h"
#include "scenegraph/nodes/SoHapticViscousZone.h"

namespace haptiv {
namespace {

class PropertyChecker {
 public:
  void notNegative(const char* field, double value, const char* unit) {
    if (value >= 0 && std::isfinite(value)) return;
    error(std::string(field) + " is " + numberText(value) + ": write 0 or more" + unit);
  }
  void positive(const char* field, double value, const char* unit) {
    if (value > 0 && std::isfinite(value)) return;
    error(std::string(field) + " is " + numberText(value) + ": write more than 0" + unit);
  }
  void finite(const char* field, const SbVec3f& v) {
    if (std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2])) return;
    error(std::string(field) + " is " + numberText(v[0]) + " " + numberText(v[1]) + " " + numberText(v[2]) +
          ": write three finite numbers, in m");
  }
  void noLessThan(const char* field, double value, const char* lesser, double least) {
    if (!(value >= 0) || !(least > value)) return;
    warn(std::string(lesser) + " is " + numberText(least) + ", above " + field + ", which is " + numberText(value) +
         ": it counts as equal to that: write a larger " + field);
  }
  void warn(std::string message) { faults.push_back({Diagnostic::Severity::warning, std::move(message)}); }
  void error(std::string message) { faults.push_back({Diagnostic::Severity::error, std::move(message)}); }

  std::vector<FieldFault> faults;
};

void check(PropertyChecker& checker, const SoHapticSurface& surface) {
  checker.notNegative("stiffness", surface.stiffness.getValue(), " N/m");
  checker.notNegative("damping", surface.damping.getValue(), " N s/m");
  checker.notNegative("hysteresis", surface.hysteresis.getValue(), " m");
  checker.notNegative("staticFriction", surface.staticFriction.getValue(), "");
  checker.notNegative("dynamicFriction", surface.dynamicFriction.getValue(), "");
  checker.noLessThan("staticFriction", surface.staticFriction.getValue(), "dynamicFriction",
                     surface.dynamicFriction.getValue());
}

void check(PropertyChecker& checker, const SoHapticSpringZone& zone) {
  checker.notNegative("stiffness", zone.stiffness.getValue(), " N/m");
  checker.notNegative("restLength", zone.restLength.getValue(), " m");
  checker.finite("anchor", zone.anchor.getValue());
}

void check(PropertyChecker& checker, const SoHapticTool& tool) {
  checker.positive("mass", tool.mass.getValue(), " kg");
  checker.notNegative("damping", tool.damping.getValue(), " N s/m");
  checker.positive("radius", tool.radius.getValue(), " m");
  checker.finite("home", tool.home.getValue());
}

void check(PropertyChecker& checker, const SoHapticDevice& device) {
  if (device.description.getValue().getLength() == 0) {
    checker.error("description is empty: write the name of a device, such as \"vishard10\"");
  }
  checker.positive("scale", device.scale.getValue(), " (scene metres per device metre)");
  checker.finite("position", device.position.getValue());
  const float* q = device.orientation.getValue().getValue();
  if (!std::isfinite(q[0]) || !std::isfinite(q[1]) || !std::isfinite(q[2]) || !std::isfinite(q[3])) {
    checker.error("orientation is not finite: write an axis and an angle in radians");
  }
}

}  // namespace

std::vector<FieldFault> checkFields(const SoNode* node) {
  PropertyChecker checker;
  const SoType type = node->getTypeId();
  if (type == SoHapticSurface::getClassTypeId()) {
    check(checker, *static_cast<const SoHapticSurface*>(node));
  } else if (type.isDerivedFrom(SoHapticSpringZone::getClassTypeId())) {
    check(checker, *static_cast<const SoHapticSpringZone*>(node));
  } else if (type == SoHapticTool::getClassTypeId()) {
    check(checker, *static_cast<const SoHapticTool*>(node));
  } else if (type == SoHapticDevice::getClassTypeId()) {
    check(checker, *static_cast<const SoHapticDevice*>(node));
  } else if (type == SoHapticViscousZone::getClassTypeId()) {
    checker.notNegative("damping", static_cast<const SoHapticViscousZone*>(node)->damping.getValue(), " N s/m");
  }
  return checker.faults;
}

}  // namespace haptiv
