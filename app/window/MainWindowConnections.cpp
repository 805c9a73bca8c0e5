#include "app/window/MainWindowParts.h"

namespace haptiv {

void MainWindow::connectFiles() {
  Parts& p = *parts_;
  connect(p.newScene, &QAction::triggered, this, [this] {
    if (mayDiscardChanges()) parts_->document->createNew();
  });
  connect(p.open, &QAction::triggered, this, &MainWindow::askToOpen);
  connect(p.save, &QAction::triggered, this, [this] { save(false); });
  connect(p.saveAs, &QAction::triggered, this, [this] { save(true); });
}

void MainWindow::connectDocument() {
  Parts& p = *parts_;
  connect(p.document, &SceneDocument::sceneReplaced, this, [this] {
    parts_->shownDevice = {};  // the file of the same name may have changed
    showDocument(true);
  });
  connect(p.document, &SceneDocument::sceneChanged, p.view, &SceneView::redraw);
  connect(p.document, &SceneDocument::sceneChanged, this, &MainWindow::showEditing);
  connect(p.document, &SceneDocument::compiling, this, [this](int shapes, int triangles) {
    constexpr int kWhile = 1500;  // [ms]
    parts_->status->showMessage(tr("Preparing the scene: %L1 shapes, %L2 triangles").arg(shapes).arg(triangles),
                                kWhile);
    parts_->status->repaint();  // the event loop does not turn meanwhile
  });
  connect(p.document, &SceneDocument::modifiedChanged, this, &MainWindow::updateTitle);
  connect(p.document, &SceneDocument::sceneCompiled, this, [this] {
    showAtRest();
    if (hasErrors(parts_->document->diagnostics())) parts_->problemsDock->raise();
  });

  const auto countProblems = [this] {
    const std::size_t count = parts_->document->diagnostics().size();
    parts_->problemsDock->setWindowTitle(count == 0 ? tr("Problems") : tr("Problems (%1)").arg(count));
  };
  connect(p.document, &SceneDocument::diagnosticsChanged, this, countProblems);
}

void MainWindow::connectSession() {
  Parts& p = *parts_;
  connect(p.stop, &QAction::triggered, p.session, &SessionControl::stop);
  connect(p.closeReplay, &QAction::triggered, this, &MainWindow::enterEditing);
  connect(p.session, &SessionControl::started, this, &MainWindow::enterSession);
  connect(p.session, &SessionControl::failed, this, &MainWindow::tell);
  connect(p.session, &SessionControl::troubled, this,
          [this](const QString& trouble) { parts_->status->showTrouble(tr("the log: %1").arg(trouble)); });
  connect(p.session, &SessionControl::stopped, this, [this] { enterReplay(parts_->session->logPath()); });
  connect(p.session, &SessionControl::ticked, this, [this](const TickRecord& record) {
    parts_->session->setHeading(parts_->view->heading());
    parts_->view->overlay().show(record);
    parts_->view->redraw();
    parts_->plots->append(record);
    parts_->status->showTick(record, parts_->session->rate());
    if (parts_->timing->isDue())
      parts_->timing->show(parts_->session->timing(), record.missedTicks, parts_->session->rate());
  });
}

void MainWindow::connectOperator() {
  Parts& p = *parts_;
  connect(p.view, &SceneView::handMoved, p.session, &SessionControl::moveHand);
  connect(p.operatorKeys, &OperatorKeys::pressed, p.session, &SessionControl::press);
  connect(p.emergencyStop, &QAction::triggered, p.operatorKeys, &OperatorKeys::stopAtOnce);
  connect(p.reset, &QAction::triggered, p.operatorKeys, &OperatorKeys::reset);
  connect(p.timing, &TimingPanel::rateChosen, p.session, &SessionControl::setRate);
  connect(p.timing, &TimingPanel::rateChosen, p.document, &SceneDocument::judgeAt);

  connect(p.control, &ControlMenu::chosen, p.session, &SessionControl::chooseControl);
}

void MainWindow::connectView() {
  Parts& p = *parts_;
  connect(p.hand, &QAction::toggled, this, [this](bool hand) {
    parts_->view->setLeftButton(hand ? SceneView::LeftButton::hand : SceneView::LeftButton::select);
  });
  connect(p.fromAbove, &QAction::toggled, this, [this](bool above) {
    if (above) {
      parts_->view->viewFromAbove();
    } else {
      parts_->view->viewFreely();
    }
  });
  connect(p.view, &SceneView::fromAboveChanged, p.fromAbove, &QAction::setChecked);
  connect(p.fromAbove, &QAction::triggered, p.view, &SceneView::viewAll);
  connect(p.showAll, &QAction::triggered, p.view, &SceneView::viewAll);
  connect(p.showArm, &QAction::toggled, this, [this](bool visible) {
    parts_->view->overlay().setArmVisible(visible);
    parts_->view->redraw();
  });
}

}  // namespace haptiv
