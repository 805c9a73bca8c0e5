#include <gtest/gtest.h>

#include <QAction>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolBar>
#include <QToolButton>
#include <cmath>

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

  QTemporaryDir home_;
  std::unique_ptr<MainWindow> window_;
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

TEST_F(Window, AWallIsAddedChangedUndoneRedoneSavedAndReopened) {
  openScene(kWallAhead);
  ASSERT_EQ(document().compiled().scene->walls.size(), 1u);

  clickButton("addWallAction");
  ASSERT_TRUE(waitFor([&] { return document().compiled().scene->walls.size() == 2; }));
  ASSERT_NE(document().selection(), nullptr) << "the new wall is not selected";

  auto& stiffness = find<QDoubleSpinBox>("stiffnessField");
  stiffness.setFocus();
  stiffness.selectAll();
  QTest::keyClicks(&stiffness, "3500");
  QTest::keyClick(&stiffness, Qt::Key_Return);
  const auto added = [&] { return document().compiled().scene->walls.back().surface.stiffness; };
  ASSERT_TRUE(waitFor([&] { return added() == 3500; })) << added();
  EXPECT_EQ(document().compiled().scene->walls.front().surface.stiffness, 2000) << "the other wall has changed too";

  clickButton("undoAction");
  EXPECT_TRUE(waitFor([&] { return added() == 2000; })) << added();
  clickButton("redoAction");
  EXPECT_TRUE(waitFor([&] { return added() == 3500; })) << added();

  const HapticScene before = *document().compiled().scene;
  EXPECT_TRUE(window_->isWindowModified());
  clickButton("saveAction");
  EXPECT_FALSE(window_->isWindowModified());

  window_->open(document().path());
  QTest::qWait(100);
  const HapticScene after = *document().compiled().scene;
  ASSERT_EQ(after.walls.size(), before.walls.size());
  for (std::size_t i = 0; i < after.walls.size(); ++i) {
    EXPECT_EQ(after.walls[i].surface.stiffness, before.walls[i].surface.stiffness);
    EXPECT_TRUE(after.walls[i].shape.centre.isApprox(before.walls[i].shape.centre, 1e-6));
    EXPECT_TRUE(after.walls[i].shape.axes.isApprox(before.walls[i].shape.axes, 1e-6));
  }
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
  clickButton("startAction");
  ASSERT_TRUE(waitFor([&] { return find<QAction>("stopAction").isEnabled(); }));
  QTest::qWait(500);

  // Take hold of the ball and pull it 12 cm ahead: well into the wall, whose face is at 4.5 cm.
  const QPointF from = view().toWidget(Vector3(0, 0, 0));
  const QPointF to = view().toWidget(Vector3(0, 0.12, 0));
  press(view(), from);
  drag(view(), from, to, 40);
  QTest::qWait(1500);
  const double reached = view().overlay().ballPosition().y();
  EXPECT_GT(reached, 0.034) << "the ball has not come to the wall";
  EXPECT_LT(reached, 0.062) << "the ball went through the wall";
  release(view(), to);
  QTest::qWait(500);
  clickButton("stopAction");

  ASSERT_TRUE(waitFor([&] { return find<QAction>("closeReplayAction").isEnabled(); }));
  const QString path = onlyLog();
  ASSERT_FALSE(path.isEmpty()) << "no log in " << logFolder().toStdString();
  const SessionLog log{path.toStdString()};
  EXPECT_TRUE(log.complete());
  EXPECT_TRUE(verify(log).identical());
  double force = 0;
  std::uint64_t hardest = 0;
  for (std::uint64_t i = 0; i < log.tickCount(); ++i) {
    const TickRecord record = log.ticks(i, 1).front();
    EXPECT_EQ(record.faults, kNoFault);
    if (record.environmentForce.norm() <= force) continue;
    force = record.environmentForce.norm();
    hardest = i;
  }
  EXPECT_GT(force, 5) << "the wall was not felt";

  // Scrub to the moment of the greatest force: the view shows the ball in the wall, the slider and the cursor agree.
  auto& slider = find<QSlider>("timeSlider");
  const double wanted = 1e-9 * static_cast<double>(log.ticks(hardest, 1).front().time);
  const double duration = 1e-9 * static_cast<double>(log.ticks(log.tickCount() - 1, 1).front().time);
  slider.setValue(static_cast<int>(std::lround(slider.maximum() * wanted / duration)));
  QTest::qWait(200);
  EXPECT_NEAR(view().overlay().ballPosition().y(), log.ticks(hardest, 1).front().position.y(), 2e-3);

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
}

}  // namespace
}  // namespace haptiv
