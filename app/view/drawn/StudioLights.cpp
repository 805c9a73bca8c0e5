#include "app/view/drawn/StudioLights.h"

#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoEnvironment.h>
#include <Inventor/nodes/SoShapeHints.h>

namespace haptiv {
namespace {

SoDirectionalLight* lamp(const SbVec3f& direction, const SbColor& color, float intensity) {
  auto* light = new SoDirectionalLight;
  light->direction = direction;
  light->color = color;
  light->intensity = intensity;
  return light;
}

}  // namespace

SoGroup* makeStudioLights() {
  auto* group = new SoGroup;
  auto* bothSides =
      new SoShapeHints;  // or the far walls of translucent shapes would be lit from behind, and look dirty
  bothSides->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
  group->addChild(bothSides);
  auto* environment = new SoEnvironment;
  environment->ambientIntensity = 1;
  environment->ambientColor = SbColor(0.96F, 0.98F, 1.0F);
  group->addChild(environment);
  group->addChild(lamp({0.3F, 0.6F, -1.0F}, {1.0F, 0.98F, 0.95F}, 0.75F));    // key, warm: high, from the front left
  group->addChild(lamp({-0.7F, -0.35F, -0.5F}, {0.90F, 0.95F, 1.0F}, 0.4F));  // fill, cool: lower, from the back right
  return group;
}

}  // namespace haptiv
