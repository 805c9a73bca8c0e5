#include "app/view/SceneView.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QColor>
#include <QTest>
#include <vector>

#include "scenegraph/reading/SceneFile.h"

namespace haptiv {
namespace {

// Two cubes beside each other; the ball rests between them.
constexpr const char* kTwoWalls = R"(#Inventor V2.1 ascii
Separator {
  Separator { Translation { translation -0.15 0 0.03 } Material { diffuseColor 0.1 0.2 0.8 }
              DEF left Cube { width 0.1 height 0.1 depth 0.06 } }
  Separator { Translation { translation 0.15 0 0.03 } Material { diffuseColor 0.1 0.7 0.2 }
              DEF right Cube { width 0.1 height 0.1 depth 0.06 } }
}
)";

class SceneViewTest : public testing::Test {
 protected:
  SceneViewTest() {
    file_ = readSceneText(kTwoWalls, "two walls");
    scene_.tool.home = {0, 0.04, 0.03};
    view_.overlay().setUp(scene_, DeviceDescription{});
    view_.resize(800, 600);
    view_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&view_));
    view_.setScene(file_.root.get(), true);
    view_.viewFromAbove();
    view_.viewAll();
    QObject::connect(&view_, &SceneView::shapeClicked, [this](const SoPath* path) {
      clicks_.push_back(path ? path->getTail()->getName().getString() : "nothing");
      startedAtRoot_ = !path || path->getHead() == file_.root.get();
    });
    QObject::connect(&view_, &SceneView::handMoved,
                     [this](const std::optional<Vector3>& p_WH) { hand_.push_back(p_WH); });
  }

  QWidget* canvas() { return view_.childAt(view_.rect().center()); }
  QPoint at(double x, double y, double z) { return canvas()->mapFrom(&view_, view_.toWidget({x, y, z}).toPoint()); }
  // QTest::mouseMove says nothing of the buttons that are down.
  void moveTo(const QPoint& pixel, Qt::MouseButton held, Qt::KeyboardModifiers keys = Qt::NoModifier) {
    QMouseEvent event(QEvent::MouseMove, pixel, canvas()->mapToGlobal(pixel), Qt::NoButton, held, keys);
    QApplication::sendEvent(canvas(), &event);
  }
  void drag(const QPoint& from, const QPoint& to, Qt::MouseButton button) {
    QTest::mousePress(canvas(), button, {}, from);
    moveTo((from + to) / 2, button);
    moveTo(to, button);
    QTest::mouseRelease(canvas(), button, {}, to);
  }

  SceneFile file_;
  HapticScene scene_;
  SceneView view_;
  std::vector<std::string> clicks_;
  bool startedAtRoot_ = false;
  std::vector<std::optional<Vector3>> hand_;
};

TEST_F(SceneViewTest, EmitsThePathOfTheShapeThatIsClicked) {
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, at(-0.15, 0, 0.06));
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, at(0.15, 0, 0.06));
  EXPECT_EQ(clicks_, (std::vector<std::string>{"left", "right"}));
  EXPECT_TRUE(startedAtRoot_);
}

TEST_F(SceneViewTest, EmitsNothingsPathForAClickOnNothing) {
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, at(0, -0.05, 0));
  EXPECT_EQ(clicks_, std::vector<std::string>{"nothing"});
}

TEST_F(SceneViewTest, DoesNotPickTheBallTheArmOrTheGrid) {
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, at(0, 0.04, 0.03));
  EXPECT_EQ(clicks_, std::vector<std::string>{"nothing"});
}

TEST_F(SceneViewTest, TakesADragForNoClick) {
  drag(at(-0.15, 0, 0.06), at(-0.12, 0, 0.06), Qt::LeftButton);
  EXPECT_TRUE(clicks_.empty());
}

TEST_F(SceneViewTest, PullsTheBallInItsPlaneAndLetsGoOnRelease) {
  view_.setLeftButton(SceneView::LeftButton::hand);
  drag(at(0, 0.04, 0.03), at(0.08, -0.03, 0.03), Qt::LeftButton);
  ASSERT_EQ(hand_.size(), 4U);  // press, two moves, release
  const double pixel = 0.002;   // [m], and the mouse moves in whole ones
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(hand_[i]);
    EXPECT_NEAR(hand_[i]->z(), 0.03, 1e-6);
  }
  EXPECT_NEAR((*hand_[0] - Vector3(0, 0.04, 0.03)).norm(), 0, 1e-9);
  EXPECT_NEAR((*hand_[2] - Vector3(0.08, -0.03, 0.03)).norm(), 0, 2 * pixel);
  EXPECT_FALSE(hand_[3]);
  EXPECT_TRUE(clicks_.empty());
}

TEST_F(SceneViewTest, PullsStraightUpWithShift) {
  view_.setLeftButton(SceneView::LeftButton::hand);
  view_.viewFreely();
  const QPoint ball = at(0, 0.04, 0.03);
  QTest::mousePress(canvas(), Qt::LeftButton, Qt::ShiftModifier, ball);
  moveTo(ball, Qt::LeftButton, Qt::ShiftModifier);
  moveTo(ball - QPoint(0, 40), Qt::LeftButton, Qt::ShiftModifier);
  ASSERT_TRUE(hand_.back());
  EXPECT_GT(hand_.back()->z(), 0.04);
  EXPECT_NEAR(hand_.back()->x(), 0, 1e-9);
  EXPECT_NEAR(hand_.back()->y(), 0.04, 1e-9);
  QTest::mouseRelease(canvas(), Qt::LeftButton, {}, ball);
}

TEST_F(SceneViewTest, DoesNotTakeHoldBesideTheBall) {
  view_.setLeftButton(SceneView::LeftButton::hand);
  drag(at(0.05, 0.0, 0.03), at(0, 0, 0.03), Qt::LeftButton);
  EXPECT_TRUE(hand_.empty());
  EXPECT_TRUE(clicks_.empty());
}

TEST_F(SceneViewTest, LetsGoWhenTheLeftButtonGetsAnotherMeaning) {
  view_.setLeftButton(SceneView::LeftButton::hand);
  QTest::mousePress(canvas(), Qt::LeftButton, {}, at(0, 0.04, 0.03));
  ASSERT_EQ(hand_.size(), 1U);
  view_.setLeftButton(SceneView::LeftButton::select);
  ASSERT_EQ(hand_.size(), 2U);
  EXPECT_FALSE(hand_.back());
}

TEST_F(SceneViewTest, ShowsAHandOverTheBallAndAClosedOneThatHoldsIt) {
  view_.setLeftButton(SceneView::LeftButton::hand);
  const QPoint ball = at(0, 0.04, 0.03);
  moveTo(at(0.1, -0.04, 0), Qt::NoButton);
  EXPECT_EQ(canvas()->cursor().shape(), Qt::ArrowCursor);
  moveTo(ball, Qt::NoButton);
  EXPECT_EQ(canvas()->cursor().shape(), Qt::OpenHandCursor);
  QTest::mousePress(canvas(), Qt::LeftButton, {}, ball);
  EXPECT_EQ(canvas()->cursor().shape(), Qt::ClosedHandCursor);
  QTest::mouseRelease(canvas(), Qt::LeftButton, {}, ball);
  EXPECT_EQ(canvas()->cursor().shape(), Qt::OpenHandCursor);
}

TEST_F(SceneViewTest, MapsXToTheRightAndYUpFromAbove) {
  const QPointF middle = view_.toWidget({0, 0, 0});
  EXPECT_GT(view_.toWidget({0.1, 0, 0}).x(), middle.x() + 50);
  EXPECT_LT(view_.toWidget({0, 0.1, 0}).y(), middle.y() - 50);
}

TEST_F(SceneViewTest, OrbitsPansAndZoomsWhateverTheLeftButtonMeans) {
  for (auto meaning : {SceneView::LeftButton::select, SceneView::LeftButton::hand}) {
    view_.setLeftButton(meaning);
    view_.viewFromAbove();
    const QPointF before = view_.toWidget({0.1, 0, 0});
    drag({300, 200}, {340, 230}, Qt::MiddleButton);
    const QPointF panned = view_.toWidget({0.1, 0, 0}) - before;
    EXPECT_NEAR(panned.x(), 40, 0.5);
    EXPECT_NEAR(panned.y(), 30, 0.5);

    QWheelEvent wheel(QPointF(300, 200), canvas()->mapToGlobal(QPoint(300, 200)), QPoint(), QPoint(0, 120),
                      Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    const double apart = (view_.toWidget({0.1, 0, 0}) - view_.toWidget({0, 0, 0})).x();
    QApplication::sendEvent(canvas(), &wheel);
    EXPECT_GT((view_.toWidget({0.1, 0, 0}) - view_.toWidget({0, 0, 0})).x(), 1.1 * apart);

    drag({300, 200}, {340, 120}, Qt::RightButton);
    EXPECT_FALSE(view_.isFromAbove());
  }
  EXPECT_TRUE(clicks_.empty());
  EXPECT_TRUE(hand_.empty());
}

TEST_F(SceneViewTest, TellsThatThePlanWentByOrbiting) {
  std::vector<bool> told;
  QObject::connect(&view_, &SceneView::fromAboveChanged, [&told](bool fromAbove) { told.push_back(fromAbove); });
  drag({300, 200}, {340, 120}, Qt::RightButton);
  view_.viewFromAbove();
  EXPECT_EQ(told, (std::vector<bool>{false, true}));
}

TEST_F(SceneViewTest, GrabsWhatItShows) {
  const QImage image = view_.grabImage();
  const QPoint left = view_.toWidget({-0.15, 0, 0.06}).toPoint();
  const QPoint right = view_.toWidget({0.15, 0, 0.06}).toPoint();
  const QPoint ball = view_.toWidget({0, 0.04, 0.03}).toPoint();
  EXPECT_GT(image.pixelColor(left).blue(), 2 * image.pixelColor(left).red());
  EXPECT_GT(image.pixelColor(right).green(), 2 * image.pixelColor(right).red());
  EXPECT_GT(image.pixelColor(ball).red(), image.pixelColor(ball).blue());
}

TEST_F(SceneViewTest, DrawsALineFromTheBallToTheHandWhileItIsHeld) {
  view_.setLeftButton(SceneView::LeftButton::hand);
  view_.overlay().setArmVisible(false);
  const QPoint ball = at(0, 0.04, 0.03);
  const QPoint hand = at(0.08, -0.04, 0.03);
  const QImage before = view_.grabImage();
  QTest::mousePress(canvas(), Qt::LeftButton, {}, ball);
  moveTo(hand, Qt::LeftButton);
  const QPoint halfWay = (ball + hand) / 2;
  const QRect around(halfWay - QPoint(3, 3), halfWay + QPoint(3, 3));
  EXPECT_NE(view_.grabImage().copy(around), before.copy(around));
  QTest::mouseRelease(canvas(), Qt::LeftButton, {}, hand);
  EXPECT_EQ(view_.grabImage().copy(around), before.copy(around));
}

TEST_F(SceneViewTest, ForgetsTheSceneWhenThereIsNone) {
  view_.setScene(nullptr, true);
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, at(0, 0, 0));
  EXPECT_EQ(clicks_, std::vector<std::string>{"nothing"});
}

}  // namespace
}  // namespace haptiv
