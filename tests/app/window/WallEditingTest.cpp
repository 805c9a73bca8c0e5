// Walls through the real window, with the mouse: added, changed, dragged, saved, felt.
#include <QAction>
#include <cmath>

#include "app/editor/edits/Edits.h"
#include "tests/app/window/WindowFixture.h"

namespace haptiv {
namespace {

using testing::click;
using testing::drag;
using testing::press;
using testing::release;
using testing::waitFor;

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

}  // namespace
}  // namespace haptiv
