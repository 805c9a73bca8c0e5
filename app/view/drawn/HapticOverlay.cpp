#include "app/view/drawn/HapticOverlay.h"

#include <Inventor/nodes/SoComplexity.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoPickStyle.h>
#include <Inventor/nodes/SoSphere.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTranslation.h>

#include "app/view/drawn/ArmFigure.h"
#include "app/view/drawn/ForceArrow.h"
#include "haptics/servo/SessionStart.h"
#include "scenegraph/CoinValues.h"

namespace haptiv {

struct HapticOverlay::Parts {
  ArmFigure arm;
  DexterityFigure dexterity;
  ForceArrow environmentArrow{SbColor(0.86F, 0.10F, 0.18F), 1};
  ForceArrow handArrow{SbColor(0.13F, 0.45F, 0.86F), 0.6};
  SoSwitch* armShown = new SoSwitch;
  SoTranslation* ballPlace = new SoTranslation;
  SoSphere* ball = new SoSphere;
  Vector3 ballPosition = Vector3::Zero();

  SoSeparator* makeBall();
  void placeBall(const Vector3& p_WT);
};

SoSeparator* HapticOverlay::Parts::makeBall() {
  auto* separator = new SoSeparator;
  separator->renderCaching = SoSeparator::OFF;
  separator->boundingBoxCaching = SoSeparator::OFF;
  auto* material = new SoMaterial;
  material->diffuseColor = SbColor(1.0F, 0.50F, 0.05F);
  material->ambientColor = SbColor(0.4F, 0.2F, 0.02F);
  material->specularColor = SbColor(0.9F, 0.9F, 0.85F);
  material->shininess = 0.85F;
  ball->radius = 0.01F;
  for (SoNode* node : std::initializer_list<SoNode*>{material, ballPlace, ball}) separator->addChild(node);
  return separator;
}

void HapticOverlay::Parts::placeBall(const Vector3& p_WT) {
  ballPosition = p_WT;
  setIfChanged(ballPlace->translation, toCoin(p_WT));
}

HapticOverlay::HapticOverlay() : parts_(std::make_unique<Parts>()), root_(new SoSeparator) {
  root_->renderCaching = SoSeparator::OFF;
  root_->boundingBoxCaching = SoSeparator::OFF;
  auto* notPicked = new SoPickStyle;
  notPicked->style = SoPickStyle::UNPICKABLE;
  auto* smooth = new SoComplexity;
  smooth->value = 0.7F;
  parts_->armShown->whichChild = SO_SWITCH_ALL;
  parts_->armShown->addChild(parts_->arm.root());
  for (SoNode* node :
       std::initializer_list<SoNode*>{notPicked, smooth, parts_->makeBall(), parts_->armShown, parts_->dexterity.root(),
                                      parts_->environmentArrow.root(), parts_->handArrow.root()}) {
    root_->addChild(node);
  }
}

HapticOverlay::~HapticOverlay() = default;

void HapticOverlay::setUp(const HapticScene& scene, const DeviceDescription& description) {
  const Tool& tool = scene.tool;
  setIfChanged(parts_->ball->radius, static_cast<float>(tool.radius));
  parts_->environmentArrow.setBallRadius(tool.radius);
  parts_->handArrow.setBallRadius(tool.radius);
  parts_->arm.setUp(scene.device, description);
  parts_->dexterity.setUp(scene.device, description);

  TickRecord atHome;
  atHome.position = tool.home;
  atHome.jointAngles = sessionStart(scene, description).angles;
  show(atHome);
}

void HapticOverlay::show(const TickRecord& record) {
  parts_->placeBall(record.position);
  parts_->arm.show(record.jointAngles);
  parts_->dexterity.show(record.position, record.jointAngles);
  parts_->environmentArrow.show(record.position, record.environmentForce);
  parts_->handArrow.show(record.position, record.handForce);
}

void HapticOverlay::setArmVisible(bool visible) {
  setIfChanged(parts_->armShown->whichChild, visible ? SO_SWITCH_ALL : SO_SWITCH_NONE);
}

void HapticOverlay::setEllipsoidVisible(Manipulability which, bool visible) {
  parts_->dexterity.setVisible(which, visible);
}

void HapticOverlay::setArmTransparency(double transparency) {
  parts_->arm.setTransparency(transparency);
}

Vector3 HapticOverlay::ballPosition() const {
  return parts_->ballPosition;
}
double HapticOverlay::ballRadius() const {
  return parts_->ball->radius.getValue();
}

}  // namespace haptiv
