#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "app/editor/Edits.h"
#include "app/editor/SceneDocument.h"
#include "app/replay/ReplayPlayer.h"
#include "app/session/Resimulation.h"
#include "app/view/SceneView.h"
#include "app/window/LogFolder.h"
#include "app/window/MainWindow.h"
#include "tests/app/window/Gestures.h"

// The main job through the real window, with the mouse: what a user does, and in that order.

namespace haptiv {
namespace {

using testing::click;
using testing::drag;
using testing::press;
using testing::release;
using testing::waitFor;

class Window : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(home_.isValid());
    qputenv("HOME", home_.path().toUtf8());
    window_ = std::make_unique<MainWindow>();
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    QTest::qWait(300);
  }

  void openScene(const std::string& text) {
    const QString path = home_.filePath("scene.iv");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(text));
    file.close();
    window_->open(path);
    ASSERT_EQ(document().path(), path);
    QTest::qWait(300);
  }

  template <typename T>
  T& find(const char* name = "") {
    T* found = window_->findChild<T*>(name);
    if (found == nullptr) throw std::runtime_error(std::string("the window has no ") + name);
    return *found;
  }
  SceneDocument& document() { return find<SceneDocument>(); }
  SceneView& view() { return find<SceneView>(); }

  /// Clicks the tool bar's button for this action, as a user does.
  void clickButton(const char* action) {
    QWidget* button = find<QToolBar>("toolBar").widgetForAction(&find<QAction>(action));
    ASSERT_NE(button, nullptr) << action;
    ASSERT_TRUE(button->isEnabled()) << action;
    ASSERT_TRUE(button->isVisible()) << action << " does not fit into the tool bar";
    QTest::mouseClick(button, Qt::LeftButton);
    QTest::qWait(50);
  }

  QString onlyLog() {
    const QStringList logs = QDir(logFolder()).entryList({"*.h5"});
    return logs.size() == 1 ? logFolder() + "/" + logs.front() : QString();
  }

  void type(const char* field, const QString& number) {
    auto& box = find<QDoubleSpinBox>(field);
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, number);
    QTest::keyClick(&box, Qt::Key_Return);
  }

  /// A session: takes hold of the ball where it is and pulls it to this place for a while; stops. Its log.
  SessionLog feel(const Vector3& target) {
    clickButton("startAction");
    EXPECT_TRUE(waitFor([&] { return find<QAction>("stopAction").isEnabled(); }));
    QTest::qWait(500);
    const QPointF from = view().toWidget(view().overlay().ballPosition());
    const QPointF to = view().toWidget(target);
    press(view(), from);
    drag(view(), from, to, 40);
    waitUntilTheBallRests();
    reached_ = view().overlay().ballPosition();
    release(view(), to);
    QTest::qWait(500);
    clickButton("stopAction");
    EXPECT_TRUE(waitFor([&] { return find<QAction>("closeReplayAction").isEnabled(); }));
    return SessionLog(onlyLog().toStdString());
  }

  /// However long that takes on a busy machine: there the simulated arm falls behind the clock.
  void waitUntilTheBallRests() {
    Vector3 before = view().overlay().ballPosition();
    EXPECT_TRUE(waitFor([&] {
      QTest::qWait(400);
      const Vector3 now = view().overlay().ballPosition();
      const bool rests = (now - before).norm() < 1e-4;
      before = now;
      return rests;
    }));
  }

  static std::uint64_t hardestTick(const SessionLog& log) {
    const std::vector<TickRecord> ticks = log.ticks(0, log.tickCount());
    const auto hardest = std::max_element(ticks.begin(), ticks.end(), [](const TickRecord& a, const TickRecord& b) {
      return a.environmentForce.norm() < b.environmentForce.norm();
    });
    return static_cast<std::uint64_t>(hardest - ticks.begin());
  }

  QTemporaryDir home_;
  std::unique_ptr<MainWindow> window_;
  Vector3 reached_ = Vector3::Zero();
};

// A wall whose face towards the ball is at y = 0.045; the ball rests at the origin's height 0.
constexpr const char* kWallAhead = R"(#Inventor V2.1 ascii
HapticDevice { position -0.3 0 0 }
HapticTool { home 0 0 0 radius 0.01 }
Separator {
  HapticSurface { stiffness 2000 label "ahead" }
  Transform { translation 0 0.05 0 }
  Material { diffuseColor 0.3 0.5 0.8 }
  Cube { width 0.3 height 0.01 depth 0.04 }
}
)";

// Only the ball, at rest in the origin's height.
constexpr const char* kNoWalls = R"(#Inventor V2.1 ascii
HapticDevice { position -0.3 0 0 }
HapticTool { home 0 0 0.02 radius 0.01 }
)";

TEST_F(Window, AWallIsAddedChangedUndoneRedoneSavedReopenedAndFelt) {
  openScene(kNoWalls);
  clickButton("addWallAction");
  ASSERT_TRUE(waitFor([&] { return document().compiled().scene->walls.size() == 1; }));
  ASSERT_NE(document().selection(), nullptr) << "the new wall is not selected";

  type("stiffnessField", "3500");
  const auto stiffness = [&] { return document().compiled().scene->walls.front().surface.stiffness; };
  ASSERT_TRUE(waitFor([&] { return stiffness() == 3500; })) << stiffness();
  clickButton("undoAction");
  EXPECT_TRUE(waitFor([&] { return stiffness() == 17000; })) << stiffness() << ": 170 N within 1 cm, as new walls are";
  clickButton("redoAction");
  EXPECT_TRUE(waitFor([&] { return stiffness() == 3500; })) << stiffness();
  type("dampingField", "20");
  const auto damping = [&] { return document().compiled().scene->walls.front().surface.damping; };
  ASSERT_TRUE(waitFor([&] { return damping() == 20; })) << damping();

  const Wall before = document().compiled().scene->walls.front();
  EXPECT_TRUE(window_->isWindowModified());
  clickButton("saveAction");
  EXPECT_FALSE(window_->isWindowModified());
  window_->open(document().path());
  QTest::qWait(300);
  ASSERT_EQ(document().compiled().scene->walls.size(), 1u);
  const Wall after = document().compiled().scene->walls.front();
  EXPECT_EQ(after.surface.stiffness, 3500);
  EXPECT_TRUE(after.shape.centre.isApprox(before.shape.centre, 1e-6));
  EXPECT_TRUE(after.shape.axes.isApprox(before.shape.axes, 1e-6));

  clickButton("fromAboveAction");
  QTest::qWait(300);
  const SessionLog log = feel(after.shape.centre);
  const TickRecord hardest = log.ticks(hardestTick(log), 1).front();
  EXPECT_GT(hardest.environmentForce.norm(), 5) << "the wall was not felt";
  EXPECT_NEAR(hardest.environmentForce.norm(), 3500 * hardest.penetration, 1 + 0.2 * hardest.environmentForce.norm())
      << "not as stiff as it was made; up to a fifth is damping on the way in";
}

TEST_F(Window, OffersToMakeAModelSolidAndDoesSo) {
  openScene("#VRML V2.0 utf8\nViewpoint { position 0 0 9 }\nShape { geometry Sphere { radius 2 } }\n");
  const auto* hint = window_->findChild<QLabel*>("hintLabel");
  ASSERT_TRUE(hint);
  EXPECT_TRUE(hint->text().contains("Make solid")) << hint->text().toStdString();
  clickButton("makeSolidAction");
  ASSERT_TRUE(waitFor([&] { return document().compiled().scene && document().compiled().scene->walls.size() == 1; }));
  EXPECT_FALSE(hint->text().contains("Make solid")) << hint->text().toStdString();
  EXPECT_TRUE(document().diagnostics().empty());
}

// Its text takes long enough to be written after the edit is felt.
TEST_F(Window, AnEditOfALargeMeshStandsInTheLogInTheEnd) {
  window_->open(QString(HAPTIV_SOURCE_DIR) + "/scenes/relief.iv");
  QTest::qWait(300);
  clickButton("startAction");
  EXPECT_TRUE(waitFor([&] { return find<QAction>("stopAction").isEnabled(); }));
  document().select(nullptr);
  const NodeRef<SoPath> path = pathTo(document().root(), listScene(document().root()).at(2).place);
  document().select(path.get());
  editProperty(
      document(), "stiffness", [](const SoField& field) { return FieldValue(field, "2500"); }, Reach::onlyThis);
  EXPECT_TRUE(waitFor([&] { return document().compiled().scene->walls.front().surface.stiffness == 2500; }));
  QTest::qWait(100);
  clickButton("stopAction");
  EXPECT_TRUE(waitFor([&] { return find<QAction>("closeReplayAction").isEnabled(); }));
  const SessionLog log(onlyLog().toStdString());
  EXPECT_EQ(log.scenes().back().scene.walls.front().surface.stiffness, 2500);
  EXPECT_NE(log.scenes().back().text.find("stiffness 2500"), std::string::npos);
  EXPECT_TRUE(verify(log).identical());
}

TEST_F(Window, AWallIsDraggedAlongTheGridWithTheMouse) {
  openScene(kWallAhead);
  clickButton("fromAboveAction");
  QTest::qWait(300);
  const Vector3 start = document().compiled().scene->walls.front().shape.centre;
  click(view(), view().toWidget(start));
  ASSERT_NE(document().selection(), nullptr) << "a click on the wall does not select it";
  QTest::qWait(200);

  const QPointF from = view().toWidget(start + Vector3(0.03, 0, 0.02));
  const QPointF to = view().toWidget(start + Vector3(0.03, 0.06, 0.02));
  press(view(), from);
  drag(view(), from, to);
  release(view(), to);
  QTest::qWait(200);

  const Vector3 end = document().compiled().scene->walls.front().shape.centre;
  EXPECT_NEAR(end.y() - start.y(), 0.06, 0.011) << "one grid step and a pixel";
  EXPECT_NEAR(end.z(), start.z(), 1e-6) << "seen from above, a wall keeps its height";
  EXPECT_EQ(document().undoStack().count(), 1) << "a drag is one step to undo";
  clickButton("undoAction");
  QTest::qWait(100);
  EXPECT_TRUE(document().compiled().scene->walls.front().shape.centre.isApprox(start, 1e-6));
}

TEST_F(Window, ASessionByMouseAgainstTheWallIsLoggedReplayedAndScrubbed) {
  openScene(kWallAhead);
  clickButton("fromAboveAction");
  QTest::qWait(300);
  const SessionLog log = feel(Vector3(0, 0.12, 0));
  EXPECT_GT(reached_.y(), 0.034) << "the ball has not come to the wall, whose face is at 45 mm";
  EXPECT_LT(reached_.y(), 0.062) << "the ball went through the wall";
  EXPECT_TRUE(log.complete());
  EXPECT_TRUE(verify(log).identical());
  const TickRecord hardest = log.ticks(hardestTick(log), 1).front();
  EXPECT_GT(hardest.environmentForce.norm(), 5) << "the wall was not felt";
  EXPECT_EQ(hardest.faults, kNoFault);

  // Scrub to the moment of the greatest force: the view shows the ball in the wall.
  auto& slider = find<QSlider>("timeSlider");
  slider.setValue(static_cast<int>(std::lround(1e-6 * static_cast<double>(hardest.time))));  // in ms
  QTest::qWait(200);
  EXPECT_NEAR(view().overlay().ballPosition().y(), hardest.position.y(), 2e-3);

  QTest::mouseClick(&find<QToolButton>("playButton"), Qt::LeftButton);
  const int before = slider.value();
  EXPECT_TRUE(waitFor([&] { return slider.value() > before; })) << "play does not move the time";

  clickButton("closeReplayAction");
  EXPECT_EQ(find<QLabel>("modeLabel").text(), "Editing");
}

TEST_F(Window, AnEditIsFeltWhileTheSessionRuns) {
  openScene(kWallAhead);
  clickButton("startAction");
  QTest::qWait(300);
  clickButton("selectAction");
  clickButton("addWallAction");
  ASSERT_TRUE(waitFor([&] { return document().compiled().scene->walls.size() == 2; }));
  QTest::qWait(300);
  clickButton("stopAction");
  ASSERT_TRUE(waitFor([&] { return find<QAction>("closeReplayAction").isEnabled(); }));
  const SessionLog log{onlyLog().toStdString()};
  EXPECT_GE(log.scenes().size(), 2u);
  EXPECT_EQ(log.scenes().back().scene.walls.size(), 2u);
  EXPECT_TRUE(verify(log).identical());
}

TEST_F(Window, HowTheArmIsDrivenIsChosenBeforeASessionAndStandsInItsLog) {
  openScene(kWallAhead);
  auto& scheme = find<QAction>("position-impedanceAction");
  EXPECT_TRUE(find<QAction>("admittanceAction").isChecked());
  scheme.trigger();
  find<QAction>("freeAction").trigger();
  EXPECT_FALSE(find<QAction>("admittanceAction").isChecked());
  clickButton("startAction");
  ASSERT_TRUE(waitFor([&] { return find<QAction>("stopAction").isEnabled(); }));
  EXPECT_FALSE(find<QMenu>("controlMenu").isEnabled()) << "not while a session runs";
  QTest::qWait(300);
  clickButton("stopAction");
  ASSERT_TRUE(waitFor([&] { return find<QAction>("closeReplayAction").isEnabled(); }));
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
  clickButton("startAction");
  ASSERT_TRUE(waitFor([&] { return find<QAction>("stopAction").isEnabled(); }));
  EXPECT_EQ(strategy.currentText(), before);
  QTest::qWait(300);
  QTest::keyClick(&strategy, Qt::Key_Down);
  const QString live = strategy.currentText();
  QTest::qWait(300);
  clickButton("stopAction");
  ASSERT_TRUE(waitFor([&] { return find<QAction>("closeReplayAction").isEnabled(); }));

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

TEST_F(Window, CountsProblemsAndSaysWhatToDoInAnEmptyScene) {
  openScene(
      "#Inventor V2.1 ascii\nHapticTool { home 0.35 0 0 }\nTranslation { translation 0.35 0.2 0 }\n"
      "HapticSurface { stiffness 2000 } Cube { width 0.1 height 0.001 depth 0.1 }\n");
  EXPECT_EQ(find<QDockWidget>("problemsDock").windowTitle(), "Problems (1)");
  find<QAction>("newAction").trigger();
  QTest::qWait(100);
  EXPECT_EQ(find<QDockWidget>("problemsDock").windowTitle(), "Problems");
  EXPECT_TRUE(find<QLabel>("hintLabel").text().contains("add walls (W)"))
      << find<QLabel>("hintLabel").text().toStdString();
}

TEST_F(Window, ABrokenSceneIsToldAndTheOldOneStays) {
  openScene(kWallAhead);
  const QString path = home_.filePath("broken.iv");
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("#Inventor V2.1 ascii\nHapticTool { radius }\n");
  file.close();
  window_->open(path);
  auto& box = find<QMessageBox>("messageBox");
  EXPECT_TRUE(box.text().contains("broken.iv:2")) << box.text().toStdString();
  box.accept();
  EXPECT_EQ(document().compiled().scene->walls.size(), 1u);
  clickButton("startAction");
  EXPECT_TRUE(waitFor([&] { return find<QAction>("stopAction").isEnabled(); })) << "the old one cannot be felt";
}

TEST_F(Window, ASpaceMouseThatIsNotThereStartsNothingAndTheMouseDoes) {
  auto& menu = find<QMenu>("handMenu");
  EXPECT_TRUE(find<QAction>("mouseHandAction").isChecked());
  find<QAction>("spaceMouseVelocityAction").trigger();
  clickButton("startAction");
  auto& box = find<QMessageBox>("messageBox");
  EXPECT_TRUE(box.text().contains("SpaceMouse")) << box.text().toStdString();
  box.accept();
  EXPECT_FALSE(find<QAction>("stopAction").isEnabled());
  find<QAction>("mouseHandAction").trigger();
  clickButton("startAction");
  EXPECT_TRUE(waitFor([&] { return find<QAction>("stopAction").isEnabled(); }));
  EXPECT_FALSE(menu.isEnabled()) << "not while a session runs";
}

TEST_F(Window, OffersTheSimulatedArmAndSaysThatNoBoardIsPluggedIn) {
  auto& menu = find<QMenu>("deviceMenu");
  emit menu.aboutToShow();
  EXPECT_TRUE(find<QAction>("simDeviceAction").isChecked());
  const QList<QAction*> items = menu.actions();
  EXPECT_TRUE(std::any_of(items.begin(), items.end(), [](QAction* item) {
    return !item->isEnabled() && item->text().contains("None is plugged in");
  }));
  clickButton("startAction");
  EXPECT_TRUE(waitFor([&] { return find<QAction>("stopAction").isEnabled(); }));
  EXPECT_FALSE(menu.isEnabled()) << "not while a session runs";
}

TEST_F(Window, TheControlMenuLeadsToTheCalibration) {
  find<QAction>("calibrateAction").trigger();
  auto& dialog = find<QDialog>("calibrationDialog");
  EXPECT_TRUE(waitFor([&] { return dialog.findChild<QLabel*>("axis1")->text() != "-"; })) << "live readings";
  EXPECT_TRUE(dialog.windowTitle().contains("vishard10"));
  QTest::mouseClick(dialog.findChild<QPushButton*>("guideClose"), Qt::LeftButton);
  EXPECT_TRUE(waitFor([&] { return window_->findChild<QDialog*>("calibrationDialog") == nullptr; }));
}

}  // namespace
}  // namespace haptiv
