#pragma once

#include <QAction>
#include <QDockWidget>
#include <memory>
#include <string>
#include <utility>

#include "app/dexterity/DexterityPanel.h"
#include "app/editor/Editor.h"
#include "app/plots/LivePlots.h"
#include "app/replay/ReplayBar.h"
#include "app/timing/TimingPanel.h"
#include "app/view/SceneView.h"
#include "app/window/ControlMenu.h"
#include "app/window/MainWindow.h"
#include "app/window/ReplayStage.h"
#include "app/window/operator/DeviceMenu.h"
#include "app/window/operator/DeviceWatch.h"
#include "app/window/operator/FalconOpening.h"
#include "app/window/operator/HandMenu.h"
#include "app/window/operator/OperatorKeys.h"
#include "app/window/session/SessionControl.h"
#include "app/window/session/SessionStatus.h"

namespace haptiv {

/// What the window is made of. Private to MainWindow's sources.
struct MainWindow::Parts {
  explicit Parts(MainWindow& window)
      : view(new SceneView(&window)),
        document(new SceneDocument(&window)),
        editor(new Editor(*document, *view, &window)),
        session(new SessionControl(*document, &window)),
        control(new ControlMenu(&window)),
        devices(new DeviceWatch(&window)),
        device(new DeviceMenu(*devices, &window)),
        heldBy(new HandMenu(*devices, &window)),
        operatorKeys(new OperatorKeys(window)),
        plots(new LivePlots(&window)),
        dexterity(new DexterityPanel(&window)),
        timing(new TimingPanel(&window)),
        replayBar(new ReplayBar(&window)),
        status(new SessionStatus(&window)) {}

  SceneView* view;
  SceneDocument* document;
  Editor* editor;
  SessionControl* session;
  ControlMenu* control;
  DeviceWatch* devices;
  DeviceMenu* device;
  HandMenu* heldBy;
  OperatorKeys* operatorKeys;
  LivePlots* plots;
  DexterityPanel* dexterity;
  TimingPanel* timing;
  ReplayBar* replayBar;
  SessionStatus* status;
  std::unique_ptr<ReplayStage> replay;

  DeviceDescription description;                    ///< of the arm that is shown at rest ...
  std::pair<std::string, std::string> shownDevice;  ///< ... as this scene file names it

  QString firmware;  ///< of a Falcon, as chosen in this window; empty: where it is looked for

  QDockWidget* propertiesDock = nullptr;
  QDockWidget* dexterityDock = nullptr;
  QDockWidget* plotsDock = nullptr;
  QDockWidget* timingDock = nullptr;
  QDockWidget* replayDock = nullptr;
  QDockWidget* problemsDock = nullptr;

  QAction* newScene = nullptr;
  QAction* open = nullptr;
  QAction* save = nullptr;
  QAction* saveAs = nullptr;
  QAction* start = nullptr;
  QAction* stop = nullptr;
  QAction* closeReplay = nullptr;
  QAction* emergencyStop = nullptr;
  QAction* reset = nullptr;
  QAction* hand = nullptr;
  QAction* select = nullptr;
  QAction* fromAbove = nullptr;
  QAction* showAll = nullptr;
  QAction* showArm = nullptr;
};

}  // namespace haptiv
