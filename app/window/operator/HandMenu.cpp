#include "app/window/operator/HandMenu.h"

#include <QActionGroup>

namespace haptiv {

HandMenu::HandMenu(QWidget* parent) : QMenu(tr("Hand &held by"), parent) {
  setObjectName("handMenu");
  auto* group = new QActionGroup(this);
  add(group, "mouseHandAction", tr("Mouse: the ball follows it"), {});
  add(group, "spaceMouseVelocityAction", tr("SpaceMouse: the cap says how fast"), SpaceMouseHand::Mode::velocity);
  add(group, "spaceMousePositionAction", tr("SpaceMouse: the cap says how far"), SpaceMouseHand::Mode::position);
  group->actions().front()->setChecked(true);
}

void HandMenu::add(QActionGroup* group, const char* name, const QString& text, const HandInput& input) {
  QAction* item = group->addAction(text);
  item->setObjectName(name);
  item->setCheckable(true);
  addAction(item);
  connect(item, &QAction::triggered, this, [this, input] { emit chosen(input); });
}

}  // namespace haptiv
