#include "app/view/drawn/ShapeBoxes.h"

#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/nodes/SoShape.h>

namespace haptiv {
namespace {

using Boxes = std::vector<SbBox3f>;

SoCallbackAction::Response beginShape(void* boxes, SoCallbackAction*, const SoNode*) {
  static_cast<Boxes*>(boxes)->emplace_back();
  return SoCallbackAction::CONTINUE;
}

void extend(void* boxes, SoCallbackAction* action, const SoPrimitiveVertex* vertex) {
  SbVec3f p_W;
  action->getModelMatrix().multVecMatrix(vertex->getPoint(), p_W);
  static_cast<Boxes*>(boxes)->back().extendBy(p_W);
}

}  // namespace

std::vector<SbBox3f> shapeBoxes(SoNode* root) {
  Boxes boxes;
  SoCallbackAction action;
  action.addPreCallback(SoShape::getClassTypeId(), beginShape, &boxes);
  action.addTriangleCallback(
      SoShape::getClassTypeId(),
      [](void* data, SoCallbackAction* at, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
         const SoPrimitiveVertex* c) {
        for (const SoPrimitiveVertex* vertex : {a, b, c}) extend(data, at, vertex);
      },
      &boxes);
  action.addLineSegmentCallback(
      SoShape::getClassTypeId(),
      [](void* data, SoCallbackAction* at, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b) {
        for (const SoPrimitiveVertex* vertex : {a, b}) extend(data, at, vertex);
      },
      &boxes);
  action.apply(root);
  return boxes;
}

}  // namespace haptiv
