// What the window's panel on dexterity shows: the arm at home, in the running session, or at the replay's cursor.
#include "app/session/choices/SceneResolution.h"
#include "app/window/MainWindowParts.h"
#include "haptics/servo/SessionStart.h"

namespace haptiv {

void MainWindow::connectDexterity() {
  Parts& p = *parts_;
  connect(p.dexterity, &DexterityPanel::chosen, p.session, &SessionControl::chooseResolution);
  connect(&p.dexterity->ellipsoids(), &EllipsoidBoxes::switched, this, [this](Manipulability which, bool visible) {
    parts_->view->overlay().setEllipsoidVisible(which, visible);
    parts_->view->redraw();
  });
  connect(p.session, &SessionControl::ticked, this,
          [this](const TickRecord& record) { parts_->dexterity->show(record.jointAngles, record.command.jointRates); });
  connect(p.document, &SceneDocument::selectionChanged, this, [this] {
    if (parts_->document->selection() != nullptr) parts_->propertiesDock->raise();
  });
}

void MainWindow::showDexterityAtRest() {
  Parts& p = *parts_;
  p.dexterity->setArm(p.description);
  p.dexterity->showChoice(p.session->resolution().value_or(p.description.redundancy.choice), true);
  p.dexterity->showMoment(tr("At home: no session runs"));
  p.dexterity->show(sessionStart(*p.document->compiled().scene, p.description).angles, JointVector::Zero());
}

void MainWindow::showDexterityOfSession() {
  Parts& p = *parts_;
  const DeviceDescription& description = p.session->description();
  p.dexterity->setArm(description);
  p.dexterity->showChoice(p.session->resolution().value_or(description.redundancy.choice), true);
  p.dexterity->showMoment(tr("Now, in the session"));
  p.dexterityDock->raise();
}

void MainWindow::showDexterityOfReplay() {
  Parts& p = *parts_;
  const ReplayPlayer& player = p.replay->player();
  const TickRecord& record = player.record();
  p.dexterity->setArm(p.replay->description());
  p.dexterity->showChoice(resolutionOf(player.scene().scene, p.replay->description()), false);
  p.dexterity->showMoment(tr("In the log at %1 s").arg(player.time(), 0, 'f', 3));
  p.dexterity->show(record.jointAngles, record.command.jointRates);
}

}  // namespace haptiv
