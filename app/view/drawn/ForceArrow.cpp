#include "app/view/drawn/ForceArrow.h"

#include <Inventor/nodes/SoAnnotation.h>
#include <Inventor/nodes/SoMaterial.h>

#include <algorithm>

#include "scenegraph/CoinValues.h"

namespace haptiv {

ForceArrow::ForceArrow(const SbColor& color, double thickness)
    : thickness_(thickness),
      root_(new SoAnnotation),
      shown_(new SoSwitch),
      place_(new SoTransform),
      toShaft_(new SoTranslation),
      shaft_(new SoCylinder),
      toHead_(new SoTranslation),
      head_(new SoCone) {
  root_->renderCaching = SoSeparator::OFF;
  root_->boundingBoxCaching = SoSeparator::OFF;
  auto* material = new SoMaterial;
  material->diffuseColor = color;
  material->emissiveColor = color * 0.1F;
  root_->addChild(shown_);
  for (SoNode* node : std::initializer_list<SoNode*>{material, place_, toShaft_, shaft_, toHead_, head_}) {
    shown_->addChild(node);
  }
  shown_->whichChild = SO_SWITCH_NONE;
}

void ForceArrow::show(const Vector3& p_WT, const Vector3& force) {
  const double norm = force.norm();
  const bool visible = norm >= kWeakestShown;
  setIfChanged(shown_->whichChild, visible ? SO_SWITCH_ALL : SO_SWITCH_NONE);
  if (!visible) return;
  setIfChanged(place_->translation, toCoin(p_WT));
  setIfChanged(place_->rotation, SbRotation(SbVec3f(0, 1, 0), toCoin(force / norm)));
  setLength(std::min(norm * kMetresPerNewton, kLongest));
}

// Along y: shaft and head from the ball's surface on. A short arrow is all head, and smaller.
void ForceArrow::setLength(double length) {
  const double headLength = std::min(1.5 * ballRadius_ * thickness_, length);
  const double headRadius = headLength * 0.36;
  const double shaftLength = std::max(length - headLength, 1e-6);
  setIfChanged(shaft_->radius, static_cast<float>(headRadius * 0.42));
  setIfChanged(shaft_->height, static_cast<float>(shaftLength));
  setIfChanged(head_->bottomRadius, static_cast<float>(headRadius));
  setIfChanged(head_->height, static_cast<float>(headLength));
  setIfChanged(toShaft_->translation, toCoin({0, ballRadius_ + shaftLength / 2, 0}));
  setIfChanged(toHead_->translation, toCoin({0, (shaftLength + headLength) / 2, 0}));
}

}  // namespace haptiv
