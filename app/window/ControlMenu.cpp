#include "app/window/ControlMenu.h"

#include <QActionGroup>

#include "device/control/ControlNames.h"

namespace haptiv {
namespace {

QString meaningOf(DisplayMode mode) {
  switch (mode) {
    case DisplayMode::admittance:
      return ControlMenu::tr("Admittance: measured force moves a virtual mass, which the arm follows");
    case DisplayMode::positionImpedance:
      return ControlMenu::tr("Position-based impedance: the scene's force where the arm is, against the measured one");
    case DisplayMode::impedance:
      return ControlMenu::tr("Impedance: the scene's force as joint torques; for light arms");
  }
  return {};
}

QString meaningOf(JointController controller) {
  return controller == JointController::pd ? ControlMenu::tr("Joints by PD: rates for the drives")
                                           : ControlMenu::tr("Joints by computed torque: the arm's rigid-body model");
}

QString meaningOf(OrientationMode mode) {
  return mode == OrientationMode::held ? ControlMenu::tr("Orientation held")
                                       : ControlMenu::tr("Orientation free: the hand turns the handle");
}

template <typename Choice>
Choice checkedOf(const QActionGroup& group) {
  return static_cast<Choice>(group.checkedAction()->data().toInt());
}

template <typename Choice>
void check(const QActionGroup& group, Choice choice) {
  for (QAction* each : group.actions()) each->setChecked(each->data().toInt() == static_cast<int>(choice));
}

}  // namespace

template <typename Choices>
QActionGroup* ControlMenu::addChoices(const QString& heading, const Choices& choices) {
  addSection(heading);
  auto* group = new QActionGroup(this);
  for (const auto each : choices) {
    QAction* item = group->addAction(meaningOf(each));
    item->setObjectName(QString::fromStdString(nameOf(each)) + "Action");
    item->setData(static_cast<int>(each));
    item->setCheckable(true);
    addAction(item);
  }
  connect(group, &QActionGroup::triggered, this, &ControlMenu::announce);
  return group;
}

ControlMenu::ControlMenu(QWidget* parent)
    : QMenu(tr("&Control"), parent),
      display_(addChoices(tr("What the arm shows"), kDisplayModes)),
      joints_(addChoices(tr("How its joints follow"), kJointControllers)),
      orientation_(addChoices(tr("The handle's orientation"), kOrientationModes)) {
  setObjectName("controlMenu");
  setToolTipsVisible(true);
  addSection(tr("At the tool"));
  passivity_ = addAction(tr("Passivity control"));
  passivity_->setObjectName("passivityAction");
  passivity_->setCheckable(true);
  connect(passivity_, &QAction::triggered, this, &ControlMenu::announce);
  showChoice({});
}

void ControlMenu::showChoice(const ControlChoice& choice) {
  check(*display_, choice.display);
  check(*joints_, choice.joints);
  check(*orientation_, choice.orientation);
  passivity_->setChecked(choice.passivity);
}

void ControlMenu::setComputedTorquePossible(bool possible) {
  for (QAction* each : joints_->actions()) {
    if (each->data().toInt() != static_cast<int>(JointController::computedTorque)) continue;
    each->setEnabled(possible);
    each->setToolTip(possible ? QString() : tr("The arm's description does not tell its links as bodies"));
  }
}

void ControlMenu::announce() {
  emit chosen({checkedOf<DisplayMode>(*display_), checkedOf<JointController>(*joints_),
               checkedOf<OrientationMode>(*orientation_), passivity_->isChecked()});
}

}  // namespace haptiv

#include "moc_ControlMenu.cpp"
