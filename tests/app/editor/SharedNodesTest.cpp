#include <gtest/gtest.h>

#include "scenegraph/compiling/SceneCompiler.h"
#include "scenegraph/reading/SceneFile.h"
#include "scenegraph/writing/SceneSaver.h"
#include "tests/app/editor/EditedScene.h"

namespace haptiv {
namespace {

/// One Separator with a wall, in all ways in which a scene may have it more than once.
constexpr char kCopies[] = R"(#Inventor V2.1 ascii
Separator {
  HapticTool { home 9 9 9 }
  DEF Post Separator {
    HapticSurface { label "post" }
    Transform { translation 0.1 0 0 }
    Cube { width 0.02 height 0.02 depth 0.04 }
  }
  Separator { Translation { translation 0 1 0 } Rotation { rotation 0 0 1 0.5 } USE Post }
  Separator { Scale { scaleFactor 2 1 3 } USE Post }
  Separator { Translation { translation 0 2 0 } Switch { whichChild 1 Cube { } USE Post } }
  Separator { Translation { translation 0 3 0 } LOD { range [ 1 ] USE Post Sphere { } } }
  Separator { Translation { translation 0 4 0 } Array { numElements1 3 separation1 1 0 0 USE Post } }
  Separator { Translation { translation 0 5 0 } MultipleCopy {
    matrix [ 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1, 1 0 0 0  0 1 0 0  0 0 1 0  1 0 0 1 ] USE Post } }
}
)";
constexpr std::size_t kWalls = 10;

/// What is felt is what a program finds that opens the file anew.
void expectAsSaved(EditedScene& scene) {
  letEventsRun();
  scene.document.save(scene.pathOf("saved.iv"));
  const SceneFile saved = readScene(scene.pathOf("saved.iv").toStdString());
  ASSERT_TRUE(saved.root);
  const CompiledScene anew = SceneCompiler().compile(saved);
  ASSERT_TRUE(anew.scene);
  const std::vector<Wall>& felt = scene.document.compiled().scene->walls;
  ASSERT_EQ(felt.size(), anew.scene->walls.size());
  for (std::size_t i = 0; i < felt.size(); ++i) {
    EXPECT_EQ(felt[i].surface.stiffness, anew.scene->walls[i].surface.stiffness) << i;
    EXPECT_TRUE(felt[i].shape.centre.isApprox(anew.scene->walls[i].shape.centre, 1e-6)) << i;
    EXPECT_TRUE(felt[i].shape.axes.isApprox(anew.scene->walls[i].shape.axes, 1e-6)) << i;
  }
}

std::vector<Wall> wallsOf(EditedScene& scene) {
  letEventsRun();
  return scene.document.compiled().scene->walls;
}

TEST(SharedNodes, ChangeInAllPlacesWhereTheyAreUsed) {
  EditedScene scene(kCopies);
  const std::vector<Wall> before = wallsOf(scene);
  ASSERT_EQ(before.size(), kWalls);
  ASSERT_TRUE(scene.select("post (2)"));
  editProperty(scene.document, "stiffness", number(700), Reach::onlyThis);
  for (const Wall& wall : wallsOf(scene)) EXPECT_EQ(wall.surface.stiffness, 700);
  moveShape(
      scene.document, [](ShapeFrame& frame) { frame.setCentre(frame.centre() + Vector3(0.01, 0.02, 0.03)); }, "move");
  const std::vector<Wall> moved = wallsOf(scene);
  for (std::size_t i = 0; i < kWalls; ++i)
    EXPECT_GT((moved[i].shape.centre - before[i].shape.centre).norm(), 0.03) << i;
  expectAsSaved(scene);
  scene.document.undoStack().undo();
  scene.document.undoStack().undo();
  const std::vector<Wall> undone = wallsOf(scene);
  for (std::size_t i = 0; i < kWalls; ++i) {
    EXPECT_EQ(undone[i].surface.stiffness, before[i].surface.stiffness);
    EXPECT_EQ(undone[i].shape.centre, before[i].shape.centre);
    EXPECT_EQ(undone[i].id, before[i].id) << "the ball's contact goes on";
  }
}

constexpr char kMade[] = R"(#VRML V2.0 utf8
PROTO Block [ field SFVec3f size 0.1 0.1 0.1 field SFFloat k 2000 field SFString name "" field SFVec3f at 0 0 0 ] {
  Transform { translation IS at children [ HapticSurface { stiffness IS k label IS name }
    Shape { geometry Box { size IS size } } ] }
}
HapticTool { home 9 9 9 }
Block { name "left" k 1500 }
Block { name "right" at 1 0 0 }
)";

TEST(SharedNodes, OfPrototypesAreEditedOneByOne) {
  EditedScene scene(kMade);
  ASSERT_EQ(wallsOf(scene).size(), 2u);
  ASSERT_TRUE(scene.select("left"));
  editProperty(scene.document, "stiffness", number(700), Reach::onlyThis);
  EXPECT_EQ(wallsOf(scene)[0].surface.stiffness, 700);
  EXPECT_EQ(wallsOf(scene)[1].surface.stiffness, 2000);
  expectAsSaved(scene);
  const CompiledScene logged = SceneCompiler().compile(readSceneText(scene.document.text(), "log"));
  ASSERT_TRUE(logged.scene);
  EXPECT_EQ(logged.scene->walls.at(0).surface.stiffness, 700) << "the text goes into logs";
  scene.document.undoStack().undo();
  EXPECT_EQ(wallsOf(scene)[0].surface.stiffness, 1500);
  expectAsSaved(scene);
}

/// Saving keeps the reference, a log has all of it.
TEST(SharedNodes, OfAnotherFileAreInTheTextForLogs) {
  EditedScene scene("#Inventor V2.1 ascii\nHapticTool { home 9 9 9 }\n");
  saveText("#Inventor V2.1 ascii\nSeparator { HapticSurface { label \"wall\" } Cube { } }",
           scene.pathOf("wall.iv").toStdString());
  saveText("#Inventor V2.1 ascii\nHapticTool { home 9 9 9 }\nFile { name \"wall.iv\" }\n",
           scene.pathOf("whole.iv").toStdString());
  ASSERT_TRUE(scene.document.open(scene.pathOf("whole.iv")));
  const CompiledScene logged = SceneCompiler().compile(readSceneText(scene.document.text(), "log"));
  ASSERT_TRUE(logged.scene);
  EXPECT_EQ(logged.scene->walls.size(), 1u);
  EXPECT_EQ(scene.document.text().find("wall.iv"), std::string::npos);
  EXPECT_EQ(wallsOf(scene).size(), 1u) << "the open scene is as it was";
  scene.document.save(scene.pathOf("saved.iv"));
  const SceneFile saved = readScene(scene.pathOf("saved.iv").toStdString());
  EXPECT_NE(saved.text.find("wall.iv"), std::string::npos);
  EXPECT_EQ(saved.text.find("Cube"), std::string::npos);
}

}  // namespace
}  // namespace haptiv
