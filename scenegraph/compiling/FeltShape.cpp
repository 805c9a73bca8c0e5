#include "scenegraph/compiling/FeltShape.h"

#include <Inventor/SbMatrix.h>
#include <Inventor/SbVec3f.h>

#include <utility>

#include "scenegraph/compiling/ShapeConversion.h"
#include "scenegraph/nodes/SoHapticRubberBand.h"
#include "scenegraph/nodes/SoHapticSpringZone.h"
#include "scenegraph/nodes/SoHapticSurface.h"
#include "scenegraph/nodes/SoHapticViscousZone.h"

namespace haptiv {
namespace {

SurfaceProperties propertiesOf(const SoHapticSurface& node) {
  return {node.stiffness.getValue(), node.damping.getValue(), node.hysteresis.getValue(),
          node.staticFriction.getValue(), node.dynamicFriction.getValue()};
}

Zone zoneOf(const FeltShape& felt) {
  Zone zone;
  zone.id = felt.id;
  if (const auto* viscous = dynamic_cast<const SoHapticViscousZone*>(&felt.property)) {
    zone.kind = Zone::Kind::viscous;
    zone.damping = viscous->damping.getValue();
  } else if (const auto* spring = dynamic_cast<const SoHapticSpringZone*>(&felt.property)) {
    zone.kind = spring->isOfType(SoHapticRubberBand::getClassTypeId()) ? Zone::Kind::rubberBand : Zone::Kind::spring;
    zone.stiffness = spring->stiffness.getValue();
    zone.restLength = spring->restLength.getValue();
    const SbVec3f& anchor = spring->anchor.getValue();
    zone.anchor = transformPoint(felt.toW, Vector3(anchor[0], anchor[1], anchor[2]));
  }
  return zone;
}

}  // namespace

Shape shapeOf(std::shared_ptr<const TriangleMesh> mesh) {
  Shape shape;
  shape.kind = Shape::Kind::mesh;
  shape.centre = (mesh->bounds.low + mesh->bounds.high) / 2;
  shape.axes = Vector3((mesh->bounds.high - mesh->bounds.low) / 2).asDiagonal();
  shape.mesh = std::move(mesh);
  return shape;
}

void addFelt(const FeltShape& felt, Shape shape, HapticScene& scene, SceneOrigins& origins) {
  if (felt.property.getTypeId() == SoHapticSurface::getClassTypeId()) {
    const auto& surface = static_cast<const SoHapticSurface&>(felt.property);
    scene.walls.push_back({felt.id, std::move(shape), propertiesOf(surface)});
    origins.walls.push_back({felt.node, &felt.property});
    return;
  }
  Zone zone = zoneOf(felt);
  zone.shape = std::move(shape);
  scene.zones.push_back(std::move(zone));
  origins.zones.push_back({felt.node, &felt.property});
}

}  // namespace haptiv
