#include "app/window/MainWindow.h"

#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <exception>

#include "app/window/MainWindowParts.h"
#include "app/window/session/LogFolder.h"

namespace haptiv {

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent) {
  parts_ = std::make_unique<Parts>(*this);
  setObjectName("mainWindow");
  resize(1280, 720);
  buildActions();
  buildMenus();
  buildToolBar();
  buildDocks();
  connectFiles();
  connectDocument();
  connectSession();
  connectOperator();
  connectView();
  connectDevices();
  connectDexterity();
  buildCalibration();
  enterEditing();
}

MainWindow::~MainWindow() {
  parts_->session->stop();
  parts_->replayBar->setPlayer(nullptr);
}

void MainWindow::enterEditing() {
  Parts& p = *parts_;
  p.replayBar->setPlayer(nullptr);
  p.replay.reset();
  p.replayDock->hide();
  p.plotsDock->show();
  p.timingDock->show();
  p.timing->clear();
  p.problemsDock->show();
  p.plotsDock->raise();
  p.propertiesDock->raise();
  for (QAction* each : {p.start, p.newScene, p.open, p.save, p.saveAs, p.select}) each->setEnabled(true);
  for (QAction* each : {p.stop, p.closeReplay, p.hand}) each->setEnabled(false);
  setOperatorPresent(false);
  p.select->setChecked(true);
  p.editor->setEnabled(true);
  p.status->clearSession();
  showEditing();
  showDocument(false);
  updateTitle();
}

void MainWindow::showEditing() {
  Parts& p = *parts_;
  if (p.replay || p.session->isRunning()) return;
  const auto& scene = p.document->compiled().scene;
  const bool isEmpty = scene && scene->walls.empty() && scene->zones.empty();
  p.status->showState(tr("Editing"),
                      p.editor->makeSolid()->isEnabled()
                          ? tr("nothing in this scene is felt yet: Edit > Make solid (M) gives it a ball and a surface")
                      : isEmpty ? tr("only the ball is here: add walls (W) and zones (D, S, R) around it")
                                : tr("click a wall to change it, or start a session to feel the scene"));
}

void MainWindow::enterSession() {
  Parts& p = *parts_;
  p.plots->clear();
  p.plotsDock->raise();
  showDexterityOfSession();
  for (QAction* each : {p.start, p.newScene, p.open}) each->setEnabled(false);
  for (QAction* each : {p.stop, p.hand}) each->setEnabled(true);
  setOperatorPresent(true);
  p.hand->setChecked(true);
  p.status->showScheduling(p.session->scheduling());
}

void MainWindow::setOperatorPresent(bool present) {
  Parts& p = *parts_;
  p.operatorKeys->setActive(present);
  for (QAction* each : {p.emergencyStop, p.reset}) each->setVisible(present);
}

void MainWindow::enterReplay(const QString& logPath) {
  Parts& p = *parts_;
  p.editor->setEnabled(false);
  p.replayBar->setPlayer(nullptr);
  p.replay.reset();
  try {
    p.replay = std::make_unique<ReplayStage>(logPath, *p.view);
  } catch (const std::exception& error) {
    enterEditing();
    tell(QString::fromUtf8(error.what()));
    return;
  }
  connect(p.replay.get(), &ReplayStage::failed, this, &MainWindow::tell);
  p.replayBar->setPlayer(&p.replay->player());
  p.plotsDock->hide();
  p.timingDock->hide();
  p.problemsDock->hide();
  p.replayDock->show();
  showDexterityOfReplay();
  connect(&p.replay->player(), &ReplayPlayer::timeChanged, this, &MainWindow::showDexterityOfReplay);
  p.dexterityDock->raise();
  for (QAction* each : {p.start, p.stop, p.hand, p.select, p.save, p.saveAs, p.newScene}) each->setEnabled(false);
  setOperatorPresent(false);
  for (QAction* each : {p.open, p.closeReplay}) each->setEnabled(true);
  p.select->setChecked(true);
  p.status->clearSession();
  p.status->showState(tr("Replay"), tr("log saved as %1").arg(logPath));
  updateTitle();
}

void MainWindow::showDocument(bool viewAll) {
  Parts& p = *parts_;
  if (p.replay) return;
  p.view->setScene(p.document->root(), false);
  showAtRest();
  if (viewAll) p.view->viewAsMeant();
  p.view->redraw();
  updateTitle();
}

// Called for every compilation, so also while a handle is dragged: the description is read only when it is another.
void MainWindow::showAtRest() {
  Parts& p = *parts_;
  const auto& scene = p.document->compiled().scene;
  if (!scene || p.replay || p.session->isRunning()) return;
  try {
    const std::string path = p.document->path().toStdString();
    if (const std::pair named{path, scene->device.description}; p.shownDevice != named) {
      p.description = loadDeviceDescription(named.second, path);
      if (p.shownDevice.second != named.second) p.session->forgetChoices();  // they were made for another arm
      p.shownDevice = named;
    }
    p.view->overlay().setUp(*scene, p.description);
    showDexterityAtRest();
    p.control->setComputedTorquePossible(!p.description.bodies.links.empty());
    p.control->showChoice(p.session->control().value_or(p.description.control.choice));
  } catch (const std::exception& error) {
    p.status->showState(tr("Editing"), QString::fromUtf8(error.what()));
  }
}

void MainWindow::updateTitle() {
  const Parts& p = *parts_;
  const QString scene = p.document->path().isEmpty() ? tr("untitled") : QFileInfo(p.document->path()).fileName();
  setWindowModified(!p.replay && p.document->isModified());
  setWindowTitle(p.replay ? tr("%1 - replay - Haptiv").arg(QFileInfo(p.replay->logPath()).fileName())
                          : tr("%1[*] - Haptiv").arg(scene));
}

void MainWindow::tell(const QString& what) {
  auto* box = new QMessageBox(QMessageBox::Warning, tr("Haptiv"), what, QMessageBox::Ok, this);
  box->setObjectName("messageBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayDiscardChanges()) {
    event->ignore();
    return;
  }
  parts_->session->stop();
  event->accept();
}

}  // namespace haptiv

#include "moc_MainWindow.cpp"
