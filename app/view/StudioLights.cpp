#include "app/view/StudioLights.h"

#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoEnvironment.h>

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
  auto* environment = new SoEnvironment;
  environment->ambientIntensity = 0.45F;
  environment->ambientColor = SbColor(0.95F, 0.97F, 1.0F);
  group->addChild(environment);
  group->addChild(
      lamp({0.35F, 0.55F, -0.9F}, {1.0F, 0.98F, 0.94F}, 0.78F));  // key, warm, from above and the front left
  group->addChild(lamp({-0.8F, -0.45F, -0.25F}, {0.86F, 0.92F, 1.0F}, 0.35F));  // fill, cool, low from the back right
  return group;
}

}  // namespace haptiv
