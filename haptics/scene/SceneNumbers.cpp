#include "haptics/scene/SceneNumbers.h"

#include <cmath>
#include <initializer_list>
#include <utility>

namespace haptiv {
namespace {

using Named = std::pair<const char*, double>;

/// The first of the numbers that is none.
std::string notFinite(const std::string& whose, std::initializer_list<Named> numbers) {
  for (const auto& [name, value] : numbers)
    if (!std::isfinite(value)) return "the " + std::string(name) + " of " + whose + " is no finite number";
  return {};
}

std::string notPositive(const std::string& whose, std::initializer_list<Named> numbers) {
  for (const auto& [name, value] : numbers)
    if (!(value > 0)) return "the " + std::string(name) + " of " + whose + " is not greater than zero";
  return {};
}

std::string wrongIn(const std::string& whose, const Shape& shape) {
  return notFinite(whose, {{"place", shape.centre.sum()}, {"size", shape.axes.sum()}});
}

/// Quickly, of a hundred thousand: a sum is finite only where all numbers of it are.
bool isFine(const Shape& shape, double others) {
  return std::isfinite(shape.centre.sum() + shape.axes.sum() + others);
}

std::string wrongIn(const Wall& wall) {
  const SurfaceProperties& s = wall.surface;
  if (isFine(wall.shape, s.stiffness + s.damping + s.hysteresis + s.staticFriction + s.dynamicFriction)) return {};
  const std::string whose = "the wall with id " + std::to_string(wall.id);
  std::string wrong = wrongIn(whose, wall.shape);
  return !wrong.empty() ? wrong
                        : notFinite(whose, {{"stiffness", s.stiffness},
                                            {"damping", s.damping},
                                            {"hysteresis", s.hysteresis},
                                            {"static friction", s.staticFriction},
                                            {"dynamic friction", s.dynamicFriction}});
}

std::string wrongIn(const Zone& zone) {
  if (isFine(zone.shape, zone.damping + zone.stiffness + zone.restLength + zone.anchor.sum())) return {};
  const std::string whose = "the zone with id " + std::to_string(zone.id);
  std::string wrong = wrongIn(whose, zone.shape);
  return !wrong.empty() ? wrong
                        : notFinite(whose, {{"damping", zone.damping},
                                            {"stiffness", zone.stiffness},
                                            {"rest length", zone.restLength},
                                            {"anchor", zone.anchor.sum()}});
}

std::string wrongIn(const Tool& tool) {
  const std::string whose = "the tool";
  std::string wrong = notFinite(
      whose, {{"mass", tool.mass}, {"damping", tool.damping}, {"radius", tool.radius}, {"home", tool.home.sum()}});
  return !wrong.empty() ? wrong : notPositive(whose, {{"mass", tool.mass}, {"radius", tool.radius}});
}

std::string wrongIn(const DevicePlacement& device) {
  const std::string whose = "the device";
  std::string wrong = notFinite(
      whose, {{"position", device.position.sum()}, {"orientation", device.rotation.sum()}, {"scale", device.scale}});
  return !wrong.empty() ? wrong : notPositive(whose, {{"scale", device.scale}});
}

}  // namespace

std::string wrongNumberIn(const HapticScene& scene) {
  if (std::string wrong = wrongIn(scene.tool); !wrong.empty()) return wrong;
  if (std::string wrong = wrongIn(scene.device); !wrong.empty()) return wrong;
  for (const Wall& wall : scene.walls)
    if (std::string wrong = wrongIn(wall); !wrong.empty()) return wrong;
  for (const Zone& zone : scene.zones)
    if (std::string wrong = wrongIn(zone); !wrong.empty()) return wrong;
  return {};
}

}  // namespace haptiv
