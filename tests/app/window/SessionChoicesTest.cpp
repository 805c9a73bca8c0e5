// How the arm is driven and its redundancy resolved: chosen in the window, kept in the log.
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QSlider>

#include "app/session/Resimulation.h"
#include "tests/app/window/WindowFixture.h"

namespace haptiv {
namespace {

using testing::waitFor;

TEST_F(Window, HowTheArmIsDrivenIsChosenBeforeASessionAndStandsInItsLog) {
  openScene(kWallAhead);
  auto& scheme = find<QAction>("position-impedanceAction");
  EXPECT_TRUE(find<QAction>("admittanceAction").isChecked());
  scheme.trigger();
  find<QAction>("freeAction").trigger();
  EXPECT_FALSE(find<QAction>("admittanceAction").isChecked());
  startSession();
  EXPECT_FALSE(find<QMenu>("controlMenu").isEnabled()) << "not while a session runs";
  QTest::qWait(300);
  stopSession();
  const SessionLog log{onlyLog().toStdString()};
  const ControlChoice chosen{DisplayMode::positionImpedance, JointController::pd, OrientationMode::free, false};
  EXPECT_EQ(log.scenes().front().scene.control, chosen);
  EXPECT_TRUE(verify(log).identical());
  clickButton("closeReplayAction");
  EXPECT_TRUE(find<QMenu>("controlMenu").isEnabled());
  EXPECT_TRUE(scheme.isChecked()) << "for the sessions that follow too";
}

TEST_F(Window, AStrategyIsChosenBeforeASessionAndLiveAndStandsInTheReplay) {
  openScene(kWallAhead);
  auto& strategy = find<QComboBox>("strategyBox");
  auto& dexterity = find<QDockWidget>("dexterityDock");
  EXPECT_TRUE(find<QLabel>("momentLabel").text().startsWith("At home"));
  dexterity.raise();
  QTest::qWait(50);
  const QString described = strategy.currentText();
  QTest::keyClick(&strategy, Qt::Key_Home);
  const QString before = strategy.currentText();
  EXPECT_NE(before, described);
  startSession();
  EXPECT_EQ(strategy.currentText(), before);
  QTest::qWait(300);
  QTest::keyClick(&strategy, Qt::Key_Down);
  const QString live = strategy.currentText();
  QTest::qWait(300);
  stopSession();

  const SessionLog log{onlyLog().toStdString()};
  ASSERT_EQ(log.scenes().size(), 2u);
  for (const LoggedScene& each : log.scenes()) EXPECT_TRUE(each.scene.resolution.has_value());
  EXPECT_NE(log.scenes()[0].scene.resolution, log.scenes()[1].scene.resolution);
  EXPECT_TRUE(verify(log).identical());
  EXPECT_FALSE(strategy.isEnabled()) << "the past cannot be chosen";
  EXPECT_EQ(strategy.currentText(), before);
  auto& slider = find<QSlider>("timeSlider");
  slider.setValue(slider.maximum());
  EXPECT_TRUE(waitFor([&] { return strategy.currentText() == live; }));
  clickButton("closeReplayAction");
  EXPECT_TRUE(strategy.isEnabled());
  EXPECT_EQ(strategy.currentText(), live) << "the choice stays for the next session";
}

}  // namespace
}  // namespace haptiv
