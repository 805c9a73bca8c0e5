#include "scenegraph/reading/coin/NurbsContext.h"

#include <Inventor/C/glue/gl.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoNurbsCurve.h>
#include <Inventor/nodes/SoSeparator.h>

#include "scenegraph/NodeRef.h"

namespace haptiv {
namespace {

/// Any address but null.
cc_glglue_offscreen_data create(unsigned int, unsigned int) {
  static char nothing = 0;
  return &nothing;
}

SbBool makeCurrent(cc_glglue_offscreen_data) {
  return TRUE;
}

void ignore(cc_glglue_offscreen_data) {}

/// Coin loads it when it first cuts something: any curve.
void loadGlu() {
  static constexpr float kPoints[2][3] = {{0, 0, 0}, {1, 0, 0}};
  static constexpr float kKnots[] = {0, 0, 1, 1};
  const NodeRef<SoSeparator> root(new SoSeparator);
  auto* points = new SoCoordinate3;
  points->point.setValues(0, 2, kPoints);
  root->addChild(points);
  auto* curve = new SoNurbsCurve;
  curve->numControlPoints = 2;
  curve->knotVector.setValues(0, 4, kKnots);
  root->addChild(curve);
  SoGetPrimitiveCountAction count;
  count.apply(root.get());
}

}  // namespace

void cutNurbsWithoutDisplay() {
  static cc_glglue_offscreen_cb_functions functions{&create, &makeCurrent, &ignore, &ignore};  // Coin keeps the pointer
  cc_glglue_context_set_offscreen_cb_functions(&functions);
  loadGlu();
}

}  // namespace haptiv
