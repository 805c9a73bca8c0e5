#include "scenegraph/reading/coin/SceneCameras.h"

#include <Inventor/VRMLnodes/SoVRMLViewpoint.h>
#include <Inventor/nodes/SoFrustumCamera.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoReversePerspectiveCamera.h>

#include "scenegraph/ReplaceNode.h"

namespace haptiv {
namespace {

template <typename Camera>
class Quiet : public Camera {
 public:
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
  replaceNode<Camera, Quiet<Camera>>();
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
