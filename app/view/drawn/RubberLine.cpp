#include "app/view/drawn/RubberLine.h"

#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoLineSet.h>
#include <Inventor/nodes/SoPickStyle.h>

#include "scenegraph/CoinValues.h"

namespace haptiv {

RubberLine::RubberLine()
    : root_(new SoSwitch), ends_(new SoCoordinate3), handPlace_(new SoTranslation), dot_(new SoSphere) {
  auto* line = new SoAnnotation;
  line->renderCaching = SoSeparator::OFF;
  line->boundingBoxCaching = SoSeparator::OFF;
  auto* notPicked = new SoPickStyle;
  notPicked->style = SoPickStyle::UNPICKABLE;
  auto* flat = new SoLightModel;
  flat->model = SoLightModel::BASE_COLOR;
  auto* color = new SoBaseColor;
  color->rgb = SbColor(0.13F, 0.45F, 0.86F);
  auto* thin = new SoDrawStyle;
  thin->lineWidth = 2;
  const SbVec3f none[] = {{0, 0, 0}, {0, 0, 0}};
  ends_->point.setValues(0, 2, none);
  auto* set = new SoLineSet;
  set->numVertices = 2;
  for (SoNode* node : std::initializer_list<SoNode*>{notPicked, flat, color, thin, ends_, set, handPlace_, dot_}) {
    line->addChild(node);
  }
  root_->addChild(line);
  hide();
}

void RubberLine::show(const Vector3& ball, double ballRadius, const Vector3& hand) {
  const SbVec3f ends[] = {toCoin(ball), toCoin(hand)};
  if (ends_->point[0] != ends[0] || ends_->point[1] != ends[1]) ends_->point.setValues(0, 2, ends);
  setIfChanged(handPlace_->translation, ends[1]);
  setIfChanged(dot_->radius, static_cast<float>(0.35 * ballRadius));
  setIfChanged(root_->whichChild, SO_SWITCH_ALL);
}

void RubberLine::hide() {
  setIfChanged(root_->whichChild, SO_SWITCH_NONE);
}

}  // namespace haptiv
