#include "app/editor/edits/Edits.h"

#include <Inventor/fields/SoSFFloat.h>
#include <Inventor/nodes/SoCube.h>
#include <gmock/gmock.h>

#include "haptics/shapes/ShapeDistance.h"
#include "tests/app/editor/EditedScene.h"

namespace haptiv {
namespace {

using testing::ElementsAre;

std::vector<double> stiffnesses(const EditedScene& scene) {
  std::vector<double> values;
  for (const Wall& wall : scene.document.compiled().scene->walls) values.push_back(wall.surface.stiffness);
  return values;
}

TEST(MoveShape, WrapsAShapeWithoutATransformInOneStep) {
  EditedScene scene(kSharedProperty);
  const std::string original = scene.document.text();
  ASSERT_TRUE(scene.select("maze (2)"));
  moveShape(
      scene.document,
      [](ShapeFrame& frame) {
        frame.setCentre({-0.1, 0.05, 0});
      },
      "move");
  letEventsRun();
  EXPECT_EQ(scene.document.undoStack().count(), 1);
  const auto& walls = scene.document.compiled().scene->walls;
  ASSERT_EQ(walls.size(), 3u);
  EXPECT_TRUE(walls[1].shape.centre.isApprox(Vector3(-0.1, 0.05, 0), 1e-6)) << "single precision";
  EXPECT_TRUE(walls[2].shape.centre.isApprox(Vector3(-0.1, 0.2, 0), 1e-6)) << "the neighbour stays";
  ASSERT_TRUE(scene.document.selection());
  EXPECT_TRUE(scene.document.selection()->getTail()->isOfType(SoCube::getClassTypeId()));

  moveShape(
      scene.document,
      [](ShapeFrame& frame) {
        frame.setCentre({-0.1, 0.06, 0});
      },
      "move");
  EXPECT_EQ(scene.document.undoStack().count(), 2);
  scene.document.undoStack().undo();
  scene.document.undoStack().undo();
  EXPECT_EQ(scene.document.text(), original);
}

TEST(EditProperty, GivesTheShapeValuesOfItsOwnWhileTheOthersKeepTheirs) {
  EditedScene scene(kSharedProperty);
  const std::string original = scene.document.text();
  ASSERT_TRUE(scene.select("maze (2)"));
  editProperty(scene.document, "stiffness", number(900), Reach::onlyThis);
  letEventsRun();
  EXPECT_THAT(stiffnesses(scene), ElementsAre(1200, 900, 1200));
  ASSERT_TRUE(scene.select("maze (1)"));
  editProperty(scene.document, "stiffness", number(800), Reach::onlyThis);
  letEventsRun();
  EXPECT_THAT(stiffnesses(scene), ElementsAre(800, 900, 1200));
  scene.document.undoStack().undo();
  scene.document.undoStack().undo();
  EXPECT_EQ(scene.document.text(), original);
}

TEST(EditProperty, ChangesAllThatShareWhenAskedTo) {
  EditedScene scene(kSharedProperty);
  ASSERT_TRUE(scene.select("maze (3)"));
  const std::vector<SceneItem> items = scene.items();
  EXPECT_EQ(sharingOf(items, *findItem(items, scene.document.selection()), scene.document.root()).shapes, 3);
  editProperty(scene.document, "stiffness", number(700), Reach::allThatShare);
  letEventsRun();
  EXPECT_THAT(stiffnesses(scene), ElementsAre(700, 700, 700));
}

TEST(DuplicateShape, PutsACopyAsideUnderALabelOfItsOwnInOneStep) {
  EditedScene scene(kTwoWalls);
  const std::string original = scene.document.text();
  ASSERT_TRUE(scene.select("left"));
  duplicateShape(scene.document);
  letEventsRun();
  const auto& walls = scene.document.compiled().scene->walls;
  ASSERT_EQ(walls.size(), 3u);
  EXPECT_EQ(walls[1].surface.stiffness, 1500);
  EXPECT_EQ(walls[1].shape.axes, walls[0].shape.axes);
  EXPECT_TRUE(walls[1].shape.centre.isApprox(Vector3(-0.08, -0.02, 0), 1e-5)) << walls[1].shape.centre.transpose();
  EXPECT_THAT(scene.names(), testing::Contains("left 1"));
  const std::vector<SceneItem> items = scene.items();
  EXPECT_EQ(findItem(items, scene.document.selection())->name, "left 1");
  EXPECT_EQ(scene.document.undoStack().count(), 1);
  scene.document.undoStack().undo();
  letEventsRun();
  EXPECT_EQ(scene.document.text(), original);
}

TEST(DuplicateShape, TakesABareShapeAndWhatItSharesStaysShared) {
  EditedScene scene(kSharedProperty);
  ASSERT_TRUE(scene.select("maze (2)"));
  duplicateShape(scene.document);
  letEventsRun();
  const auto& walls = scene.document.compiled().scene->walls;
  ASSERT_EQ(walls.size(), 4u);
  EXPECT_TRUE(walls[2].shape.centre.isApprox(Vector3(-0.08, -0.02, 0), 1e-5)) << walls[2].shape.centre.transpose();
  EXPECT_TRUE(walls[3].shape.centre.isApprox(Vector3(-0.1, 0.2, 0), 1e-5)) << "what comes after it stays";
  EXPECT_EQ(walls[2].surface.stiffness, 1200);
}

TEST(DuplicateShape, IsNotForBallAndDevice) {
  EditedScene scene(kTwoWalls);
  ASSERT_TRUE(scene.select("ball"));
  EXPECT_FALSE(canDuplicate(scene.document));
  duplicateShape(scene.document);
  EXPECT_EQ(scene.document.undoStack().count(), 0);
}

TEST(RemoveShape, LeavesTheOtherUsesOfTheShape) {
  EditedScene scene(R"(#Inventor V2.1 ascii
Separator {
  HapticTool { }
  DEF Post Separator { HapticSurface { } Transform { translation 0.1 0 0 } Cube { width 0.02 height 0.02 depth 0.04 } }
  Separator { Translation { translation 0 0.1 0 } USE Post }
  Separator { Translation { translation 0 0.2 0 } USE Post }
})");
  const std::string original = scene.document.text();
  ASSERT_TRUE(scene.select("Post (2)"));
  removeShape(scene.document);
  letEventsRun();
  const auto& walls = scene.document.compiled().scene->walls;
  ASSERT_EQ(walls.size(), 2u);
  EXPECT_TRUE(walls[0].shape.centre.isApprox(Vector3(0.1, 0, 0), 1e-6));
  EXPECT_TRUE(walls[1].shape.centre.isApprox(Vector3(0.1, 0.2, 0), 1e-6));
  scene.document.undoStack().undo();
  letEventsRun();
  EXPECT_EQ(scene.document.text(), original);
  EXPECT_EQ(scene.document.compiled().scene->walls.size(), 3u);
}

TEST(RemoveShape, TakesABareShapeOutFromAmongOthers) {
  EditedScene scene(kSharedProperty);
  ASSERT_TRUE(scene.select("maze (2)"));
  removeShape(scene.document);
  letEventsRun();
  EXPECT_EQ(scene.document.compiled().scene->walls.size(), 2u);
  EXPECT_EQ(scene.document.selection(), nullptr);
}

TEST(RemoveShape, LeavesToolAndDevice) {
  EditedScene scene(kTwoWalls);
  ASSERT_TRUE(scene.select("ball"));
  removeShape(scene.document);
  EXPECT_EQ(scene.document.undoStack().count(), 0);
}

TEST(AddShape, PutsWallsOnTheGridClearOfTheBallAndOfEachOther) {
  EditedScene scene(kTwoWalls);
  for (int i = 0; i < 12; ++i) {
    addShape(scene.document, SceneItem::Kind::wall);
    letEventsRun();
  }
  const HapticScene& compiled = *scene.document.compiled().scene;
  ASSERT_EQ(compiled.walls.size(), 14u);
  for (std::size_t i = 2; i < compiled.walls.size(); ++i) {
    const Shape& shape = compiled.walls[i].shape;
    EXPECT_GT(nearestSurface(shape, compiled.tool.home).distance, compiled.tool.radius);
    const Vector3 low = shape.centre - shape.axes.diagonal();
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(low[axis] * 100, std::round(low[axis] * 100), 1e-4) << "single precision, in centimetres";
    }
    for (std::size_t j = 0; j < i; ++j) {
      const Shape& other = compiled.walls[j].shape;
      const Vector3 gap = (shape.centre - other.centre).cwiseAbs() - shape.axes.diagonal() - other.axes.diagonal();
      EXPECT_GT(gap.maxCoeff(), -1e-6) << i << " meets " << j;
    }
  }
}

TEST(AddShape, SeesWhatWasAddedInTheSameTurn) {
  EditedScene scene(kTwoWalls);
  addShape(scene.document, SceneItem::Kind::dampingZone);
  addShape(scene.document, SceneItem::Kind::springZone);
  letEventsRun();
  const auto& zones = scene.document.compiled().scene->zones;
  ASSERT_EQ(zones.size(), 2u);
  const Vector3 gap = (zones[0].shape.centre - zones[1].shape.centre).cwiseAbs() - zones[0].shape.axes.diagonal() -
                      zones[1].shape.axes.diagonal();
  EXPECT_GT(gap.maxCoeff(), -1e-6) << "they touch at most";
}

TEST(AddShape, GivesEachItsOwnLabelAndSelectsIt) {
  EditedScene scene(kTwoWalls);
  addShape(scene.document, SceneItem::Kind::wall);
  addShape(scene.document, SceneItem::Kind::wall);
  addShape(scene.document, SceneItem::Kind::springZone);
  EXPECT_THAT(scene.names(), ElementsAre("vishard10", "ball", "left", "right", "wall 1", "wall 2", "spring zone 1"));
  const std::vector<SceneItem> items = scene.items();
  const SceneItem* selected = findItem(items, scene.document.selection());
  ASSERT_TRUE(selected);
  EXPECT_EQ(selected->label, "spring zone 1");
  EXPECT_EQ(scene.document.undoStack().count(), 3) << "one step each";
}

TEST(AddShape, StandsWhereItShouldUnderATransformOfTheRoot) {
  EditedScene scene(R"(#Inventor V2.1 ascii
Separator { HapticTool { } Translation { translation 3 2 1 } })");
  addShape(scene.document, SceneItem::Kind::wall);
  letEventsRun();
  ASSERT_EQ(scene.document.compiled().scene->walls.size(), 1u);
  EXPECT_LT(scene.document.compiled().scene->walls[0].shape.centre.norm(), 0.1);
  EXPECT_EQ(scene.document.undoStack().count(), 1);
}

TEST(AddShape, MakesAWallAsStiffAsItsThicknessAsksFor) {
  EditedScene scene("#Inventor V2.1 ascii\nHapticTool { home 0.3 0 0 }\n");
  addShape(scene.document, SceneItem::Kind::wall);
  addShape(scene.document, SceneItem::Kind::rubberBand);
  letEventsRun();
  const HapticScene& compiled = *scene.document.compiled().scene;
  ASSERT_EQ(compiled.walls.size(), 1u);
  EXPECT_EQ(compiled.walls[0].surface.stiffness, 17000) << "170 N / 1 cm";
  ASSERT_EQ(compiled.zones.size(), 1u);
  EXPECT_EQ(compiled.zones[0].kind, Zone::Kind::rubberBand);
  EXPECT_GT(compiled.zones[0].restLength, 0);
  EXPECT_TRUE(scene.document.diagnostics().empty()) << toText(scene.document.diagnostics().front());
}

const char kModel[] = "#Inventor V2.1 ascii\nSeparator { Cube { } Translation { translation 3 0 0 } Sphere { } }\n";

TEST(MakeSolid, IsOneStepThatCanBeUndone) {
  EditedScene scene(kModel);
  EXPECT_TRUE(isScenery(scene.items()));
  EXPECT_FALSE(scene.document.compiled().scene) << "there is no tool";
  const std::string before = scene.document.text();
  makeSolid(scene.document);
  letEventsRun();
  EXPECT_EQ(scene.document.undoStack().count(), 1);
  EXPECT_FALSE(isScenery(scene.items()));
  ASSERT_TRUE(scene.document.compiled().scene);
  EXPECT_EQ(scene.document.compiled().scene->walls.size(), 2u);
  EXPECT_TRUE(scene.document.diagnostics().empty()) << toText(scene.document.diagnostics().front());
  scene.document.undoStack().undo();
  letEventsRun();
  EXPECT_EQ(scene.document.text(), before);
}

TEST(MakeSolid, TakesNegativeLengthsAsTheyAreDrawn) {
  EditedScene scene("#Inventor V2.1 ascii\nCube { width -2 }\n");
  const std::string before = scene.document.text();
  makeSolid(scene.document);
  letEventsRun();
  ASSERT_TRUE(scene.document.compiled().scene);
  EXPECT_EQ(scene.document.compiled().scene->walls.size(), 1u);
  scene.document.undoStack().undo();
  letEventsRun();
  EXPECT_EQ(scene.document.text(), before);
}

TEST(MakeSolid, IsNotForScenesThatSayWhatIsFelt) {
  EXPECT_FALSE(isScenery(EditedScene(kTwoWalls).items()));
  EXPECT_FALSE(isScenery(EditedScene("#Inventor V2.1 ascii\nHapticTool { }\n").items())) << "nothing is there";
  EXPECT_FALSE(isScenery(EditedScene("#Inventor V2.1 ascii\nHapticNone { } Cube { }\n").items()));
}

}  // namespace
}  // namespace haptiv
