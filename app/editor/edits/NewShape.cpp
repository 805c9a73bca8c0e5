#include "app/editor/edits/NewShape.h"

#include <Inventor/fields/SoSFFloat.h>
#include <Inventor/fields/SoSFString.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoTransform.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "app/editor/edits/Grid.h"
#include "scenegraph/judging/ContactDynamics.h"

namespace haptiv {
namespace {

using Box = Eigen::AlignedBox<double, 3>;

constexpr double kRestLength = 0.02;  // of a new rubber band [m]

struct Recipe {
  const char* keyword;
  const char* stem;
  Vector3 size;  ///< [m]
  SbColor colour;
  float transparency;
};

Recipe recipeOf(SceneItem::Kind kind) {
  switch (kind) {
    case SceneItem::Kind::dampingZone:
      return {"HapticViscousZone", "damping zone", {0.10, 0.10, 0.04}, {0.20f, 0.50f, 0.85f}, 0.6f};
    case SceneItem::Kind::springZone:
      return {"HapticSpringZone", "spring zone", {0.10, 0.10, 0.04}, {0.95f, 0.60f, 0.15f}, 0.6f};
    case SceneItem::Kind::rubberBand:
      return {"HapticRubberBand", "rubber band", {0.10, 0.10, 0.04}, {0.35f, 0.65f, 0.40f}, 0.6f};
    default:
      return {"HapticSurface", "wall", {0.10, 0.01, 0.04}, {0.60f, 0.64f, 0.70f}, 0.0f};
  }
}

Box boxAround(const Shape& shape) {
  const Vector3 half = shape.axes.cwiseAbs().rowwise().sum();
  return {shape.centre - half, shape.centre + half};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Thickness and height as the walls that are there, within reason.
Vector3 sizeLike(const std::vector<Wall>& walls, const Vector3& usual) {
  if (walls.empty()) return usual;
  std::vector<double> thicknesses, heights;
  for (const Wall& wall : walls) {
    const Vector3 size = boxAround(wall.shape).sizes();
    thicknesses.push_back(std::min(size.x(), size.y()));
    heights.push_back(size.z());
  }
  const Grid grid;
  return {usual.x(), std::clamp(grid.snapped(median(thicknesses)), 0.01, 0.05),
          std::clamp(grid.snapped(median(heights)), 0.01, 0.20)};
}

/// The lowest corner, on the grid, of the nearest free place to the ball.
Vector3 freeCorner(const HapticScene& scene, const Vector3& size) {
  constexpr int kReach = 30;  // grid steps to each side
  std::vector<Box> taken;
  for (const Wall& wall : scene.walls) taken.push_back(boxAround(wall.shape));
  for (const Zone& zone : scene.zones) taken.push_back(boxAround(zone.shape));
  const Vector3 margin = Vector3::Constant(scene.tool.radius + Grid::kStep);
  taken.emplace_back(scene.tool.home - margin, scene.tool.home + margin);

  const Grid grid;
  const Vector3 middle = grid.snapped(Vector3(scene.tool.home - size / 2));
  Vector3 best = middle + Vector3(0, kReach * Grid::kStep, 0);
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = -kReach; i <= kReach; ++i) {
    for (int j = -kReach; j <= kReach; ++j) {
      const double distance = std::hypot(i, j);
      if (distance >= nearest) continue;
      const Vector3 corner = middle + Grid::kStep * Vector3(i, j, 0);
      const Vector3 slack = Vector3::Constant(1e-6);  // touching is free
      const Box box(corner + slack, corner + size - slack);
      const auto meets = [&](const Box& other) { return box.intersects(other); };
      if (std::any_of(taken.begin(), taken.end(), meets)) continue;
      best = corner;
      nearest = distance;
    }
  }
  return best;
}

NodeRef<SoNode> make(const char* word, const QString& label) {
  const SoType type = SoType::fromName(word);
  if (type.isBad() || !type.canCreateInstance()) throw std::logic_error(std::string("No node type ") + word);
  NodeRef<SoNode> node(static_cast<SoNode*>(type.createInstance()));
  if (auto* field = dynamic_cast<SoSFString*>(node->getField("label"))) field->setValue(label.toUtf8().constData());
  return node;
}

void set(SoNode& node, const char* field, double value) {
  if (auto* number = dynamic_cast<SoSFFloat*>(node.getField(field))) number->setValue(static_cast<float>(value));
}

/// A thin wall needs more than the usual stiffness to keep the device's peak force within it, k >= F / thickness, and
/// damping to go with it, eq. (33).
void fitToThickness(SoNode& surface, double thickness, const SceneDocument& document, const Tool& tool) {
  const double least = std::ceil(document.device().hand.peakForce / thickness / 1000) * 1000;
  if (least <= SurfaceProperties().stiffness) return;
  set(surface, "stiffness", least);
  set(surface, "damping", std::round(ContactDynamics{tool.mass, least, 0}.optimalDamping()));
}

}  // namespace

NewShape newShape(SceneDocument& document, SceneItem::Kind kind) {
  const Recipe recipe = recipeOf(kind);
  const auto compiled = document.compileNow().scene;
  const HapticScene scene = compiled ? *compiled : HapticScene();
  const Vector3 size = kind == SceneItem::Kind::wall ? sizeLike(scene.walls, recipe.size) : recipe.size;

  NewShape made;
  made.label = unusedLabel(listScene(document.root()), recipe.stem);
  made.centre = freeCorner(scene, size) + size / 2;
  made.node = NodeRef<SoSeparator>(new SoSeparator);
  const NodeRef<SoNode> property = make(recipe.keyword, made.label);
  if (kind == SceneItem::Kind::wall) fitToThickness(*property.get(), size.head<2>().minCoeff(), document, scene.tool);
  if (kind == SceneItem::Kind::rubberBand) set(*property.get(), "restLength", kRestLength);
  made.node->addChild(property.get());
  auto* transform = new SoTransform;
  const Eigen::Vector3f centre = made.centre.cast<float>();
  transform->translation.setValue(centre.x(), centre.y(), centre.z());
  made.node->addChild(transform);
  auto* material = new SoMaterial;
  material->diffuseColor = recipe.colour;
  if (recipe.transparency > 0) material->transparency = recipe.transparency;
  made.node->addChild(material);
  auto* cube = new SoCube;
  cube->width = static_cast<float>(size.x());
  cube->height = static_cast<float>(size.y());
  cube->depth = static_cast<float>(size.z());
  made.node->addChild(cube);
  return made;
}

}  // namespace haptiv
