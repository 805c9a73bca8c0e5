#include "app/editor/handles/Handles.h"

#include <Inventor/SbViewportRegion.h>
#include <Inventor/actions/SoHandleEventAction.h>
#include <Inventor/events/SoLocation2Event.h>
#include <Inventor/events/SoMouseButtonEvent.h>
#include <Inventor/manips/SoHandleBoxManip.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <gmock/gmock.h>

#include <QSignalSpy>

#include "app/editor/edits/Edits.h"
#include "tests/app/editor/EditedScene.h"

namespace haptiv {
namespace {

constexpr short kSide = 400;  // pixels
constexpr double kPixelsPerMetre = 1000;

/// The mouse over the scene as seen from straight above, a millimetre a pixel; no window, no drawing.
class MouseFromAbove {
 public:
  explicit MouseFromAbove(EditedScene& scene) : world_(new SoSeparator), action_(SbViewportRegion(kSide, kSide)) {
    auto* camera = new SoOrthographicCamera;
    camera->position.setValue(0, 0, 1);
    camera->height = static_cast<float>(kSide / kPixelsPerMetre);
    camera->nearDistance = 0.1f;
    camera->farDistance = 2;
    world_->addChild(camera);
    world_->addChild(scene.document.root());
  }

  void press(double x, double y) { button(x, y, SoButtonEvent::DOWN); }
  void release(double x, double y) { button(x, y, SoButtonEvent::UP); }
  void move(double x, double y) {
    SoLocation2Event event;
    send(event, x, y);
  }
  void drag(double fromX, double fromY, double toX, double toY) {
    press(fromX, fromY);
    constexpr int kSteps = 10;
    for (int i = 1; i <= kSteps; ++i) {
      move(fromX + (toX - fromX) * i / kSteps, fromY + (toY - fromY) * i / kSteps);
    }
    release(toX, toY);
  }

 private:
  void button(double x, double y, SoButtonEvent::State state) {
    SoMouseButtonEvent event;
    event.setButton(SoMouseButtonEvent::BUTTON1);
    event.setState(state);
    send(event, x, y);
  }
  void send(SoEvent& event, double x, double y) {
    event.setPosition(SbVec2s(static_cast<short>(kSide / 2 + x * kPixelsPerMetre),
                              static_cast<short>(kSide / 2 + y * kPixelsPerMetre)));
    action_.setEvent(&event);
    action_.apply(world_.get());
  }

  NodeRef<SoSeparator> world_;
  SoHandleEventAction action_;
};

const Shape& wall(const EditedScene& scene, std::size_t i) {
  return scene.document.compiled().scene->walls.at(i).shape;
}

constexpr double kSingle = 1e-6;  // single precision at these lengths

/// Takes hold of the wall around (-0.1, 0.02) and moves it by 33 mm and 34 mm.
void dragAcross(EditedScene& scene) {
  MouseFromAbove mouse(scene);
  mouse.drag(-0.096, 0.023, -0.063, 0.057);
  letEventsRun();
}

TEST(Handles, ComeWithTheSelectionAndGoWithIt) {
  EditedScene scene(kTwoWalls);
  Handles handles(scene.document);
  const std::string original = scene.document.text();
  ASSERT_TRUE(scene.select("left"));
  EXPECT_TRUE(handles.manip());
  EXPECT_EQ(scene.document.text(), original) << "no manip is ever written";
  EXPECT_FALSE(handles.manip());
  letEventsRun();
  EXPECT_TRUE(handles.manip()) << "they are back after the writing";
  handles.setEnabled(false);
  EXPECT_FALSE(handles.manip());
  handles.setEnabled(true);
  scene.document.select(nullptr);
  letEventsRun();
  EXPECT_FALSE(handles.manip());
}

TEST(Handles, DoNotChangeWhatIsFelt) {
  EditedScene scene(kSharedProperty);
  Handles handles(scene.document);
  const Vector3 centre = wall(scene, 1).centre;
  ASSERT_TRUE(scene.select("maze (2)"));
  ASSERT_TRUE(handles.manip());
  scene.document.noteChange();
  letEventsRun();
  EXPECT_EQ(wall(scene, 1).centre, centre);
  EXPECT_EQ(scene.document.compiled().scene->walls.size(), 3u);
  EXPECT_EQ(scene.document.undoStack().count(), 0);
}

TEST(Handles, MoveAWallOnTheGridInOneUndoStep) {
  EditedScene scene(kTwoWalls);
  Handles handles(scene.document);
  const std::string original = scene.document.text();
  ASSERT_TRUE(scene.select("left"));
  dragAcross(scene);
  EXPECT_EQ(scene.document.undoStack().count(), 1);
  // moved by 33 mm and 34 mm: three steps of the grid
  EXPECT_TRUE(wall(scene, 0).centre.isApprox(Vector3(-0.07, 0.03, 0), kSingle)) << wall(scene, 0).centre.transpose();
  EXPECT_TRUE(wall(scene, 0).axes.diagonal().isApprox(Vector3(0.01, 0.05, 0.02), kSingle));
  scene.document.undoStack().undo();
  EXPECT_EQ(scene.document.text(), original);
}

TEST(Handles, LetTheMovingWallBeFeltWhileItMoves) {
  EditedScene scene(kTwoWalls);
  Handles handles(scene.document);
  ASSERT_TRUE(scene.select("left"));
  MouseFromAbove mouse(scene);
  QSignalSpy compiled(&scene.document, &SceneDocument::sceneCompiled);
  const ShapeId id = scene.document.compiled().scene->walls[0].id;
  mouse.press(-0.096, 0.023);
  mouse.move(-0.09, 0.04);
  mouse.move(-0.076, 0.063);
  EXPECT_TRUE(handles.isDragging());
  letEventsRun();
  EXPECT_EQ(compiled.count(), 1);
  EXPECT_TRUE(wall(scene, 0).centre.isApprox(Vector3(-0.08, 0.04, 0), kSingle)) << wall(scene, 0).centre.transpose();
  EXPECT_EQ(scene.document.compiled().scene->walls[0].id, id) << "the tool's contact survives";
  EXPECT_EQ(scene.document.undoStack().count(), 0);
  mouse.release(-0.076, 0.063);
  letEventsRun();
  EXPECT_EQ(scene.document.undoStack().count(), 1);
}

TEST(Handles, ResizeWithTheOtherSideAtRest) {
  EditedScene scene(kTwoWalls);
  Handles handles(scene.document);
  ASSERT_TRUE(scene.select("left"));
  MouseFromAbove mouse(scene);
  mouse.drag(-0.1, 0.056, -0.1, 0.085);  // the knob on the far face
  letEventsRun();
  const Shape& shape = wall(scene, 0);
  EXPECT_NEAR(shape.centre.y() + shape.axes(1, 1), 0.08, kSingle);
  EXPECT_NEAR(shape.centre.y() - shape.axes(1, 1), -0.05, kSingle);
  EXPECT_NEAR(shape.axes(0, 0), 0.01, kSingle);
  EXPECT_EQ(scene.document.undoStack().undoText().toStdString(), "resizing");
}

TEST(Handles, StretchAWallFarBeyondTwiceItsLength) {
  EditedScene scene(kTwoWalls);
  Handles handles(scene.document);
  ASSERT_TRUE(scene.select("left"));
  MouseFromAbove mouse(scene);
  mouse.drag(-0.1, -0.056, -0.1, -0.193);
  letEventsRun();
  const Shape& shape = wall(scene, 0);
  EXPECT_NEAR(shape.centre.y() + shape.axes(1, 1), 0.05, kSingle);
  EXPECT_NEAR(shape.centre.y() - shape.axes(1, 1), -0.19, kSingle);
}

TEST(Handles, NeverMakeAWallThinnerThanItCanBe) {
  EditedScene scene(kTwoWalls);
  Handles handles(scene.document);
  ASSERT_TRUE(scene.select("left"));
  MouseFromAbove mouse(scene);
  mouse.press(-0.1, 0.056);
  for (int y = 50; y > -150; y -= 10) {
    mouse.move(-0.1, y / 1000.0);
    letEventsRun();
    ASSERT_FALSE(hasErrors(scene.document.diagnostics()));
    ASSERT_GE(2 * wall(scene, 0).axes.col(1).norm(), ShapeFrame::kMinSize - kSingle);
  }
  mouse.release(-0.1, -0.15);
  letEventsRun();
  EXPECT_GT(wall(scene, 0).axes(1, 1), 0);
}

TEST(Handles, MoveFreelyWhenTheGridIsOff) {
  EditedScene scene(kTwoWalls);
  Handles handles(scene.document);
  handles.setSnapping(false);
  ASSERT_TRUE(scene.select("left"));
  dragAcross(scene);
  // the dragger takes whole pixels of a millimetre
  EXPECT_TRUE(wall(scene, 0).centre.isApprox(Vector3(-0.067, 0.034, 0), 0.02)) << wall(scene, 0).centre.transpose();
}

TEST(Handles, WrapABareShapeWhenItIsDragged) {
  EditedScene scene(kSharedProperty);
  Handles handles(scene.document);
  const std::string original = scene.document.text();
  ASSERT_TRUE(scene.select("maze (2)"));
  dragAcross(scene);
  EXPECT_EQ(scene.document.undoStack().count(), 1);
  EXPECT_TRUE(wall(scene, 1).centre.isApprox(Vector3(-0.07, 0.03, 0), kSingle)) << wall(scene, 1).centre.transpose();
  EXPECT_TRUE(wall(scene, 2).centre.isApprox(Vector3(-0.1, 0.2, 0), kSingle));
  EXPECT_TRUE(handles.manip()) << "it stays selected";
  scene.document.undoStack().undo();
  EXPECT_EQ(scene.document.text(), original);
}

TEST(Handles, DropADragThatAnotherEditInterrupts) {
  EditedScene scene(kTwoWalls);
  Handles handles(scene.document);
  ASSERT_TRUE(scene.select("left"));
  MouseFromAbove mouse(scene);
  mouse.press(-0.096, 0.023);
  mouse.move(-0.06, 0.06);
  addShape(scene.document, SceneItem::Kind::wall);
  mouse.move(-0.05, 0.05);
  mouse.release(-0.05, 0.05);
  letEventsRun();
  EXPECT_FALSE(handles.isDragging());
  EXPECT_EQ(scene.document.undoStack().count(), 1);
  EXPECT_TRUE(wall(scene, 0).centre.isApprox(Vector3(-0.1, 0, 0), kSingle));
}

}  // namespace
}  // namespace haptiv
