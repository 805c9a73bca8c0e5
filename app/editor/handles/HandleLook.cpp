#include "app/editor/handles/HandleLook.h"

#include <Inventor/draggers/SoDragger.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTranslation.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "scenegraph/CoinValues.h"

namespace haptiv {
namespace {

const SbColor kResting(0.95f, 0.55f, 0.10f);
const SbColor kHeld(1.0f, 0.85f, 0.20f);

/// In the dragger's frame, where the shape reaches from -1 to 1.
SoSeparator* knob(const Vector3& place, const Vector3& lengths, const SbColor& colour) {
  auto* node = new SoSeparator;
  auto* material = new SoMaterial;
  material->diffuseColor = colour;
  material->emissiveColor = colour * 0.4f;
  node->addChild(material);
  auto* shift = new SoTranslation;
  shift->translation = toCoin(place);
  node->addChild(shift);
  auto* cube = new SoCube;
  cube->width = static_cast<float>(lengths.x());
  cube->height = static_cast<float>(lengths.y());
  cube->depth = static_cast<float>(lengths.z());
  node->addChild(cube);
  return node;
}

void dress(SoDragger& dragger, const std::string& part, const Vector3& place, const Vector3& lengths) {
  dragger.setPart(part.c_str(), knob(place, lengths, kResting));
  dragger.setPart((part + "Active").c_str(), knob(place, lengths, kHeld));
}

}  // namespace

void dressHandles(SoDragger& dragger, const Vector3& halfSize) {
  // as Coin numbers its parts: the faces +y -y -x +x +z -z, and the corners
  const Vector3 faces[] = {Vector3::UnitY(), -Vector3::UnitY(), -Vector3::UnitX(),
                           Vector3::UnitX(), Vector3::UnitZ(),  -Vector3::UnitZ()};
  const Vector3 corners[] = {{1, 1, 1},  {1, 1, -1},  {1, -1, 1},  {1, -1, -1},
                             {-1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1}};
  const double side = std::clamp(0.3 * std::cbrt(halfSize.prod()), 0.004, 0.5);  // [m]
  const Vector3 lengths = side * halfSize.cwiseInverse();
  for (int i = 0; i < 6; ++i) {
    const Vector3 place = faces[i].cwiseProduct(Vector3::Ones() + lengths);
    dress(dragger, "extruder" + std::to_string(i + 1), place, lengths);
  }
  for (int i = 0; i < 8; ++i) dress(dragger, "uniform" + std::to_string(i + 1), corners[i], 0.7 * lengths);
}

}  // namespace haptiv
