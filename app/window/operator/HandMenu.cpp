#include "app/window/operator/HandMenu.h"

#include <QActionGroup>

#include "app/window/operator/DeviceText.h"

namespace haptiv {

HandMenu::HandMenu(DeviceWatch& watch, QWidget* parent)
    : QMenu(tr("Hand &held by"), parent), watch_(watch), ways_(new QActionGroup(this)), mice_(new QActionGroup(this)) {
  setObjectName("handMenu");
  setToolTipsVisible(true);
  offerWay("mouseHandAction", tr("Mouse: the ball follows it"), {});
  offerWay("spaceMouseVelocityAction", tr("SpaceMouse: the cap says how fast"), SpaceMouseHand::Mode::velocity);
  offerWay("spaceMousePositionAction", tr("SpaceMouse: the cap says how far"), SpaceMouseHand::Mode::position);
  ways_->actions().front()->setChecked(true);
  refresh();
  connect(&watch, &DeviceWatch::changed, this, &HandMenu::refresh);
  connect(this, &QMenu::aboutToShow, &watch, &DeviceWatch::look);
}

/// What is chosen stays in the menu, plugged in or not: a session says what is wrong.
void HandMenu::refresh() {
  clear();
  addActions(ways_->actions());
  addSection(tr("Which SpaceMouse"));
  listMice();
  if (mice_->checkedAction() != nullptr || which_.isEmpty()) return;
  const bool isListed = watch_.known() && watch_.known()->trouble.empty();
  offerMouse(which_, which_ + (isListed ? notPluggedIn() : QString()), tr("Plug it in, or choose another one"));
}

void HandMenu::listMice() {
  const auto tell = [this](const QString& what) { addAction(what)->setEnabled(false); };
  if (!watch_.known()) return tell(lookingForDevices());
  if (const std::string& trouble = watch_.known()->trouble; !trouble.empty())
    return tell(QString::fromStdString(trouble));
  bool isAny = false;
  for (const PluggedDevice& device : watch_.known()->devices) {
    if (device.kind != PluggedKind::spaceMouse) continue;
    if (!isAny) offerMouse({}, tr("The only one that is plugged in"), {});
    isAny = true;
    offerMouse(QString::fromStdString(device.which), textOf(device), QString::fromStdString(device.trouble));
  }
  if (!isAny) tell(tr("None is plugged in"));
}

void HandMenu::offerWay(const char* name, const QString& text, std::optional<SpaceMouseHand::Mode> mode) {
  QAction* item = ways_->addAction(text);
  item->setObjectName(name);
  item->setCheckable(true);
  addAction(item);
  // By way of the group: a menu that is cleared cuts its items' connections with itself.
  connect(item, &QAction::triggered, ways_, [this, mode] {
    mode_ = mode;
    tell();
  });
}

void HandMenu::offerMouse(const QString& which, const QString& text, const QString& trouble) {
  QAction* item = addAction(text);
  item->setObjectName("spaceMouse:" + which + "Action");
  item->setActionGroup(mice_);
  item->setCheckable(true);
  item->setChecked(which == which_);
  item->setToolTip(trouble);
  connect(item, &QAction::triggered, this, [this, which] {
    which_ = which;
    if (!mode_) ways_->actions().at(1)->setChecked(true);  // whoever chooses one wants to use it
    mode_ = mode_.value_or(SpaceMouseHand::Mode::velocity);
    tell();
  });
}

void HandMenu::tell() {
  emit chosen(mode_ ? HandInput(SpaceMouseChoice{*mode_, which_.toStdString()}) : HandInput());
}

}  // namespace haptiv

#include "moc_HandMenu.cpp"
