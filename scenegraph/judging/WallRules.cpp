#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "scenegraph/NumberText.h"
#include "scenegraph/judging/ContactDynamics.h"
#include "scenegraph/judging/Findings.h"
#include "scenegraph/judging/PerProperty.h"
#include "scenegraph/judging/Rules.h"

namespace haptiv {
namespace {

constexpr double kRounding = 1e-4;  // sizes and transforms of a scene are single precision

/// Between the nearest two opposite faces; of a mesh, of the box around it.
double thicknessOf(const Shape& shape) {
  const Matrix3& a = shape.axes;
  if (shape.kind == Shape::Kind::sphere) return 2 * a.col(0).norm();
  if (shape.kind != Shape::Kind::box) return 2 * a.colwise().norm().minCoeff();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vector3 across = a.col((i + 1) % 3).cross(a.col((i + 2) % 3));
    least = std::min(least, 2 * std::abs(across.dot(a.col(i))) / across.norm());
  }
  return least;
}

/// What is wrong with a spring and damper of the scene; empty: nothing.
std::string stabilityFault(const ContactDynamics& contact, const JudgedScene& judged) {
  const double dt = judged.period();
  const double drives = judged.device.drives.bandwidth.minCoeff();
  const std::string optimal = "; the optimal stiffness b^2/2m is " + numberText(contact.optimalStiffness()) + " N/m";
  if (contact.usedOfSampledBound(dt) >= 1) {
    const double largest = contact.largestSampledStiffness(dt);
    const std::string sum = numberText(4 * contact.usedOfSampledBound(dt));
    const std::string bound = "cannot be rendered stably at " + numberText(judged.rate) +
                              " Hz: k dt^2/m + 2 b dt/m is " + sum + " and must be below 4: ";
    if (largest <= 0)
      return bound + "write a damping below 2 m/dt = " + numberText(2 * contact.mass / dt) +
             " N s/m, or a larger mass" + optimal;
    return bound + "write a stiffness below " + numberText(largest) + " N/m, or a larger mass" + optimal;
  }
  if (contact.naturalFrequency() > drives) {
    return "is too stiff for the arm: its natural frequency sqrt(k/m) is " + numberText(contact.naturalFrequency()) +
           " rad/s and the drives follow to " + numberText(drives) + " rad/s: write a stiffness below " +
           numberText(contact.mass * drives * drives) + " N/m, or a larger mass" + optimal;
  }
  return {};
}

ContactDynamics dynamicsOf(const Zone& zone, const Tool& tool) {
  if (zone.kind == Zone::Kind::viscous) return {tool.mass, 0, zone.damping + tool.damping};
  return {tool.mass, zone.stiffness, tool.damping};
}

}  // namespace

Diagnostics judgeThickness(const JudgedScene& judged) {
  const double peak = judged.device.hand.peakForce;
  Findings found;
  for (const PropertyGroup& group : groupByProperty(judged.origins.walls)) {
    const double stiffness = judged.scene.walls[group.members.front()].surface.stiffness;
    std::size_t thin = 0;
    std::size_t thinnest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t wall : group.members) {
      const double thickness = thicknessOf(judged.scene.walls[wall].shape);
      if (thickness * stiffness < peak * (1 - kRounding)) ++thin;
      if (thickness < least) {
        least = thickness;
        thinnest = wall;
      }
    }
    if (thin == 0) continue;
    const std::string which =
        thin > 1 ? "is the thinnest of " + std::to_string(thin) + " walls that are too thin, " : "is ";
    const std::string depth =
        stiffness > 0 ? lengthText(peak / stiffness) + " deep (F/k)" : "through it, for it has no stiffness";
    const std::string remedy =
        least > 0 ? "give it a stiffness of " + numberText(std::ceil(peak / least)) + " N/m or more, or make it thicker"
                  : "make it stiffer, or give it some thickness";
    found.warn(judged.origins.walls[thinnest].shape,
               which + lengthText(least) + " thick, and the device's peak force of " + numberText(peak) +
                   " N presses the ball " + depth +
                   ": it does not pop through, yet is seen on the other side: " + remedy);
  }
  return std::move(found).take();
}

Diagnostics judgeStability(const JudgedScene& judged) {
  const HapticScene& scene = judged.scene;
  Findings found;
  const auto judge = [&](const SoNode* node, const ContactDynamics& contact) {
    const std::string fault = stabilityFault(contact, judged);
    if (!fault.empty()) found.warn(node, fault);
  };
  judge(judged.origins.tool, {scene.tool.mass, 0, scene.tool.damping});
  for (const PropertyGroup& group : groupByProperty(judged.origins.walls)) {
    const SurfaceProperties& surface = scene.walls[group.members.front()].surface;
    judge(group.property, {scene.tool.mass, surface.stiffness, surface.damping});
  }
  for (const PropertyGroup& group : groupByProperty(judged.origins.zones))
    judge(group.property, dynamicsOf(scene.zones[group.members.front()], scene.tool));
  return std::move(found).take();
}

}  // namespace haptiv
