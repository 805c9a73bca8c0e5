// Sessions through the real window: felt, edited meanwhile, logged, replayed.
#include <QAction>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <cmath>

#include "app/editor/edits/Edits.h"
#include "app/session/Resimulation.h"
#include "tests/app/window/WindowFixture.h"

namespace haptiv {
namespace {

using testing::waitFor;

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
  stopSession();
  const SessionLog log{onlyLog().toStdString()};
  EXPECT_GE(log.scenes().size(), 2u);
  EXPECT_EQ(log.scenes().back().scene.walls.size(), 2u);
  EXPECT_TRUE(verify(log).identical());
}

TEST_F(Window, AnEditOfALargeMeshStandsInTheLogInTheEnd) {
  window_->open(QString(HAPTIV_SOURCE_DIR) + "/scenes/relief.iv");
  QTest::qWait(300);
  startSession();
  document().select(nullptr);
  const NodeRef<SoPath> path = pathTo(document().root(), listScene(document().root()).at(2).place);
  document().select(path.get());
  editProperty(
      document(), "stiffness", [](const SoField& field) { return FieldValue(field, "2500"); }, Reach::onlyThis);
  EXPECT_TRUE(waitFor([&] { return document().compiled().scene->walls.front().surface.stiffness == 2500; }));
  QTest::qWait(100);
  stopSession();
  const SessionLog log(onlyLog().toStdString());
  EXPECT_EQ(log.scenes().back().scene.walls.front().surface.stiffness, 2500);
  EXPECT_NE(log.scenes().back().text.find("stiffness 2500"), std::string::npos);
  EXPECT_TRUE(verify(log).identical());
}

}  // namespace
}  // namespace haptiv
