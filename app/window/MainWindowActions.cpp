// The window's menus, tool bar and docks: what there is and where it stands. What it does is in MainWindow.cpp.
#include <QActionGroup>
#include <QApplication>
#include <QMenuBar>
#include <QStyle>
#include <QToolBar>

#include "app/window/MainWindowParts.h"
#include "app/window/WindowIcons.h"

namespace haptiv {

namespace {

QAction* action(MainWindow* window, const char* name, const QString& text, const QString& tip,
                const QKeySequence& shortcut = {}, bool checkable = false) {
  auto* action = new QAction(text, window);
  action->setObjectName(name);
  action->setToolTip(shortcut.isEmpty() ? tip : QString("%1 (%2)").arg(tip, shortcut.toString()));
  action->setShortcut(shortcut);
  action->setCheckable(checkable);
  return action;
}

QIcon standardIcon(QStyle::StandardPixmap pixmap) {
  return QApplication::style()->standardIcon(pixmap);
}

}  // namespace

void MainWindow::buildActions() {
  Parts& p = *parts_;
  p.newScene = action(this, "newAction", tr("New"), tr("Start an empty scene"), QKeySequence::New);
  p.open = action(this, "openAction", tr("Open..."), tr("Open a scene or a session log"), QKeySequence::Open);
  p.open->setIcon(standardIcon(QStyle::SP_DialogOpenButton));
  p.save = action(this, "saveAction", tr("Save"), tr("Save the scene"), QKeySequence::Save);
  p.save->setIcon(standardIcon(QStyle::SP_DialogSaveButton));
  p.saveAs = action(this, "saveAsAction", tr("Save as..."), tr("Save the scene under another name"), {"Ctrl+Shift+S"});
  p.start = action(this, "startAction", tr("Start session"), tr("Feel the scene; the session is logged"), {"F5"});
  p.start->setIcon(standardIcon(QStyle::SP_MediaPlay));
  p.stop = action(this, "stopAction", tr("Stop"), tr("End the session and replay it"), {"F6"});
  p.stop->setIcon(standardIcon(QStyle::SP_MediaStop));
  p.closeReplay = action(this, "closeReplayAction", tr("Close replay"), tr("Back to the scene"), {"Ctrl+W"});
  p.closeReplay->setIcon(standardIcon(QStyle::SP_DialogCloseButton));
  p.emergencyStop = action(this, "emergencyStopAction", tr("Emergency stop"), tr("Brake the arm at once (Esc)"));
  p.emergencyStop->setIcon(iconOf(WindowIcon::emergencyStop));
  p.reset = action(this, "resetAction", tr("Reset"), tr("After a fault: make the arm ready again"), {"F7"});
  p.reset->setIcon(standardIcon(QStyle::SP_BrowserReload));
  p.hand = action(this, "handAction", tr("Hand"), tr("The left mouse button is the hand on the ball"), {"H"}, true);
  p.select =
      action(this, "selectAction", tr("Select"), tr("The left mouse button selects and moves shapes"), {"V"}, true);
  auto* group = new QActionGroup(this);
  group->addAction(p.hand);
  group->addAction(p.select);
  p.fromAbove = action(this, "fromAboveAction", tr("From above"), tr("Look straight down on the scene"), {"P"}, true);
  p.showAll = action(this, "showAllAction", tr("Show all"), tr("Bring the whole scene into view"), {"A"});
  p.showArm = action(this, "showArmAction", tr("Arm"), tr("Show the device's arm"), {}, true);
  p.showArm->setChecked(true);
}

void MainWindow::buildMenus() {
  Parts& p = *parts_;
  QMenu* file = menuBar()->addMenu(tr("&File"));
  file->addActions({p.newScene, p.open, p.save, p.saveAs});
  file->addSeparator();
  connect(file->addAction(tr("Quit")), &QAction::triggered, this, &QWidget::close);
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  edit->addActions({p.editor->undo(), p.editor->redo()});
  edit->addSeparator();
  edit->addActions({p.editor->addWall(), p.editor->addDampingZone(), p.editor->addSpringZone(),
                    p.editor->addRubberBand(), p.editor->duplicate(), p.editor->remove()});
  edit->addSeparator();
  edit->addAction(p.editor->makeSolid());
  edit->addSeparator();
  edit->addAction(p.editor->snapToGrid());
  QMenu* session = menuBar()->addMenu(tr("&Session"));
  session->addActions({p.start, p.stop, p.closeReplay});
  session->addSeparator();
  session->addActions({p.emergencyStop, p.reset});
  session->addSeparator();
  session->addActions({p.hand, p.select});
  session->addMenu(p.device);
  session->addMenu(p.heldBy);
  menuBar()->addMenu(p.control);
  QMenu* look = menuBar()->addMenu(tr("&View"));
  look->addActions({p.fromAbove, p.showAll, p.showArm});
  look->addSeparator();
  for (const Manipulability which : {Manipulability::translational, Manipulability::rotational})
    look->addAction(p.dexterity->ellipsoids().action(which));
}

void MainWindow::buildToolBar() {
  Parts& p = *parts_;
  p.hand->setIcon(iconOf(WindowIcon::hand));
  p.select->setIcon(iconOf(WindowIcon::select));
  p.fromAbove->setIcon(iconOf(WindowIcon::fromAbove));
  p.showAll->setIcon(iconOf(WindowIcon::showAll));
  p.showArm->setIcon(iconOf(WindowIcon::arm));
  p.editor->addWall()->setIconText(tr("Wall"));
  p.editor->addDampingZone()->setIconText(tr("Damping zone"));
  p.editor->addSpringZone()->setIconText(tr("Spring zone"));
  p.editor->addRubberBand()->setIconText(tr("Rubber band"));
  // What users know by its picture goes without words, so that all fits into 1280 pixels.
  for (QAction* known :
       {p.open, p.save, p.editor->undo(), p.editor->redo(), p.editor->remove(), p.editor->snapToGrid(), p.emergencyStop,
        p.reset, p.editor->addRubberBand(), p.editor->makeSolid(), p.fromAbove, p.showAll, p.showArm}) {
    known->setPriority(QAction::LowPriority);
  }

  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName("toolBar");
  bar->setMovable(false);
  bar->setIconSize({22, 22});
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  bar->addActions({p.open, p.save});
  bar->addSeparator();
  bar->addActions({p.start, p.stop, p.emergencyStop, p.reset, p.hand, p.select, p.closeReplay});
  bar->addSeparator();
  bar->addActions({p.editor->undo(), p.editor->redo()});
  bar->addSeparator();
  bar->addActions({p.editor->addWall(), p.editor->addDampingZone(), p.editor->addSpringZone(),
                   p.editor->addRubberBand(), p.editor->makeSolid(), p.editor->remove(), p.editor->snapToGrid()});
  bar->addSeparator();
  bar->addActions({p.fromAbove, p.showAll, p.showArm});
}

void MainWindow::buildDocks() {
  Parts& p = *parts_;
  const auto add = [this](const char* name, const QString& title, QWidget* content, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(content);
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    addDockWidget(area, dock);
    return dock;
  };
  setCentralWidget(p.view);
  setStatusBar(p.status);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  add("treeDock", tr("Scene"), p.editor->sceneTree(), Qt::LeftDockWidgetArea);
  p.propertiesDock = add("propertiesDock", tr("Properties"), p.editor->propertyPanel(), Qt::RightDockWidgetArea);
  p.dexterityDock = add("dexterityDock", tr("Dexterity"), p.dexterity, Qt::RightDockWidgetArea);
  tabifyDockWidget(p.propertiesDock, p.dexterityDock);
  p.propertiesDock->raise();
  p.plotsDock = add("plotsDock", tr("Force, position, energy"), p.plots, Qt::BottomDockWidgetArea);
  p.problemsDock = add("problemsDock", tr("Problems"), p.editor->diagnosticsList(), Qt::BottomDockWidgetArea);
  tabifyDockWidget(p.plotsDock, p.problemsDock);
  p.timingDock = add("timingDock", tr("Timing"), p.timing, Qt::BottomDockWidgetArea);
  tabifyDockWidget(p.problemsDock, p.timingDock);
  p.plotsDock->raise();
  p.replayDock = add("replayDock", tr("Replay"), p.replayBar, Qt::BottomDockWidgetArea);
  p.replayDock->hide();
  resizeDocks({p.plotsDock}, {190}, Qt::Vertical);

  QMenu* panels = menuBar()->addMenu(tr("&Panels"));
  for (QDockWidget* each : findChildren<QDockWidget*>()) {
    if (each != p.replayDock) panels->addAction(each->toggleViewAction());
  }
}

}  // namespace haptiv
