// Sessions with a Falcon in the window: homed, felt, stopped, cancelled, refused.
#include <QLabel>

#include "tests/app/window/devices/FalconWindow.h"

namespace haptiv {
namespace {

using testing::waitFor;

TEST_F(FalconWindow, IsHomedByTheOperatorAndFeltAndStoppedByEsc) {
  startUntilItAsks();
  EXPECT_FALSE(find<QAction>("startAction").isEnabled());
  picture("falcon-homing");
  falcon().faults().operatorHomes = true;
  EXPECT_TRUE(waitFor([&] { return find<QAction>("stopAction").isEnabled(); }, 30'000));
  const QLabel& state = find<QLabel>("modeLabel");
  EXPECT_TRUE(waitFor([&] { return state.text() == "Ready"; }));
  EXPECT_TRUE(find<QLabel>("hintLabel").text().contains("dead-man")) << find<QLabel>("hintLabel").text().toStdString();
  falcon().setButtons(falcon::Logic::kDeadManButton);
  EXPECT_TRUE(waitFor([&] { return state.text() == "Running"; }));
  picture("falcon-running");
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_TRUE(waitFor([&] { return state.text().contains("emergency stop"); })) << state.text().toStdString();
  EXPECT_TRUE(waitFor([&] { return falcon().lastOrder().motors == falcon::Order{}.motors; }));
  picture("falcon-stopped");
  falcon().setButtons(0);
  find<QAction>("resetAction").trigger();
  EXPECT_TRUE(waitFor([&] { return state.text() == "Ready"; })) << state.text().toStdString();
  stopSession();
  EXPECT_EQ(state.text(), "Replay") << "its log is whole";
}

TEST_F(FalconWindow, CancelledWhileItIsHomedAllIsAsBefore) {
  QProgressDialog& dialog = startUntilItAsks();
  emit dialog.canceled();
  EXPECT_TRUE(waitFor([&] { return find<QAction>("startAction").isEnabled(); }));
  EXPECT_EQ(window_->findChild<QMessageBox*>("messageBox"), nullptr) << "nothing went wrong";
  EXPECT_FALSE(find<QAction>("stopAction").isEnabled());
  falcon().faults().homesByItself = true;
  clickButton("startAction");
  EXPECT_TRUE(waitFor([&] { return find<QAction>("stopAction").isEnabled(); }, 30'000)) << "and it can be started anew";
  stopSession();
}

TEST_F(FalconWindow, OfASceneForAnotherArmIsRefused) {
  openScene(kNoWalls);
  clickButton("startAction");
  EXPECT_TRUE(messageOnce().contains("vishard10"));
  EXPECT_TRUE(find<QAction>("startAction").isEnabled());
}

}  // namespace
}  // namespace haptiv
