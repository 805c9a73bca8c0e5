#include "scenegraph/reading/coin/FinestLevels.h"

#include <Inventor/VRMLnodes/SoVRMLLOD.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/misc/SoChildList.h>
#include <Inventor/nodes/SoLOD.h>
#include <Inventor/nodes/SoLevelOfDetail.h>

#include "scenegraph/ReplaceNode.h"

namespace haptiv {
namespace {

/// Levels by distance.
template <typename Levels>
class Finest final : public Levels {
 protected:
  int whichToTraverse(SoAction*) override { return this->getNumChildren() > 0 ? 0 : -1; }
};

/// Levels by area on the screen.
class FinestOfAreas final : public SoLevelOfDetail {
 public:
  void doAction(SoAction* action) override {
    const SoAction::PathCode code = action->getCurPathCode();
    if (code == SoAction::IN_PATH) return SoGroup::doAction(action);
    if (code != SoAction::OFF_PATH && getNumChildren() > 0) getChildren()->traverse(action, 0);
  }
  void callback(SoCallbackAction* action) override { doAction(action); }
  void GLRender(SoGLRenderAction* action) override { doAction(action); }
  void rayPick(SoRayPickAction* action) override { doAction(action); }
  void getPrimitiveCount(SoGetPrimitiveCountAction* action) override { doAction(action); }
};

}  // namespace

void showFinestLevels() {
  replaceNode<SoLOD, Finest<SoLOD>>();
  replaceNode<SoVRMLLOD, Finest<SoVRMLLOD>>();
  replaceNode<SoLevelOfDetail, FinestOfAreas>();
}

}  // namespace haptiv
