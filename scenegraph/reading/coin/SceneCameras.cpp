#include "scenegraph/reading/coin/SceneCameras.h"

#include <Inventor/SoType.h>
#include <Inventor/VRMLnodes/SoVRMLViewpoint.h>
#include <Inventor/nodes/SoFrustumCamera.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoReversePerspectiveCamera.h>

namespace haptiv {
namespace {

/// Of the camera's own type to Coin, so that files stay what they are.
template <typename Camera>
class Quiet : public Camera {
 public:
  static void* make() { return new Quiet; }

  void doAction(SoAction*) override {}
  void callback(SoCallbackAction*) override {}
  void GLRender(SoGLRenderAction*) override {}
  void getBoundingBox(SoGetBoundingBoxAction*) override {}
  void handleEvent(SoHandleEventAction*) override {}
  void rayPick(SoRayPickAction*) override {}
  void getPrimitiveCount(SoGetPrimitiveCountAction*) override {}
};

template <typename Camera>
void quiet() {
  SoType::overrideType(Camera::getClassTypeId(), &Quiet<Camera>::make);
}

}  // namespace

void quietSceneCameras() {
  quiet<SoPerspectiveCamera>();
  quiet<SoOrthographicCamera>();
  quiet<SoReversePerspectiveCamera>();
  quiet<SoFrustumCamera>();
  quiet<SoVRMLViewpoint>();
}

}  // namespace haptiv
