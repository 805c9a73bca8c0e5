#include <gmock/gmock.h>

#include <QCheckBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>

#include "app/editor/edits/Edits.h"
#include "tests/app/editor/EditedScene.h"
#include "tests/app/editor/panels/PanelWidgets.h"

namespace haptiv {
namespace {

double stiffness(const EditedScene& scene, std::size_t wall) {
  return scene.document.compiled().scene->walls.at(wall).surface.stiffness;
}

TEST(PropertyPanel, SaysHowToSelectWhenNothingIs) {
  EditedScene scene(kTwoWalls);
  PropertyPanel panel(scene.document);
  EXPECT_EQ(field<QLabel>(panel, "selectionName").text(), "Nothing selected");
  EXPECT_THAT(field<QLabel>(panel, "selectionHint").text().toStdString(), testing::HasSubstr("Click"));
}

TEST(PropertyPanel, SetsTheStiffnessOfAWallThatUndoTakesBack) {
  EditedScene scene(kTwoWalls);
  PropertyPanel panel(scene.document);
  ASSERT_TRUE(scene.select("left"));
  auto& box = field(panel, "stiffnessField");
  EXPECT_EQ(box.value(), 1500);
  EXPECT_EQ(box.suffix(), " N/m");
  box.setValue(2500);
  letEventsRun();
  EXPECT_EQ(stiffness(scene, 0), 2500);
  EXPECT_EQ(stiffness(scene, 1), 2000);
  scene.document.undoStack().undo();
  letEventsRun();
  EXPECT_EQ(box.value(), 1500);
  EXPECT_EQ(stiffness(scene, 0), 1500);
  scene.document.undoStack().redo();
  letEventsRun();
  EXPECT_EQ(box.value(), 2500);
}

TEST(PropertyPanel, ShowsWhatTheSceneHasBeyondTheRangesOfItsFields) {
  EditedScene scene(
      "#Inventor V2.1 ascii\nHapticTool { home 0.3 0 0 mass 0.002 }\nTranslation { translation 0.3 0.2 0 }\n"
      "HapticSurface { stiffness 5e7 damping -5 label \"odd\" }\nCube { width 0.1 height 0.1 depth 0.1 }\n");
  PropertyPanel panel(scene.document);
  ASSERT_TRUE(scene.select("odd"));
  EXPECT_EQ(field(panel, "stiffnessField").value(), 5e7);
  EXPECT_EQ(field(panel, "dampingField").value(), -5);
  ASSERT_TRUE(scene.select("ball"));
  EXPECT_EQ(field(panel, "massField").text(), "0.002 kg");
  EXPECT_EQ(scene.document.undoStack().count(), 0) << "to look is not to change";
}

// m = 2 kg, k = 9000 N/m, b = 190 N s/m: 190 / (2 sqrt(2 9000)) = 0.708, by (32).
TEST(PropertyPanel, TellsHowAWallAnswersAndAZoneNothingOfIt) {
  EditedScene scene(
      "#Inventor V2.1 ascii\nHapticTool { home 0.3 0 0 }\nTranslation { translation 0.3 0.2 0 }\n"
      "HapticSurface { stiffness 9000 damping 190 label \"wall\" }\nCube { width 0.1 height 0.1 depth 0.1 }\n"
      "HapticViscousZone { label \"zone\" }\nCube { width 0.2 height 0.2 depth 0.2 }\n");
  PropertyPanel panel(scene.document);
  panel.show();
  ASSERT_TRUE(scene.select("wall"));
  auto& told = field<QLabel>(panel, "wallDynamics");
  EXPECT_THAT(told.text().toStdString(), testing::HasSubstr("Damping ratio 0.71"));
  EXPECT_THAT(told.text().toStdString(), testing::HasSubstr("170 N presses the ball 1.9 cm deep"));
  EXPECT_TRUE(told.isVisible());
  ASSERT_TRUE(scene.select("zone"));
  EXPECT_FALSE(told.isVisible());
}

TEST(PropertyPanel, MergesTheStepsOfARunningSpinBox) {
  EditedScene scene(kTwoWalls);
  PropertyPanel panel(scene.document);
  ASSERT_TRUE(scene.select("left"));
  auto& box = field(panel, "stiffnessField");
  for (int i = 0; i < 5; ++i) {
    box.stepUp();
    letEventsRun();
  }
  EXPECT_EQ(stiffness(scene, 0), 2000);
  EXPECT_EQ(scene.document.undoStack().count(), 1);
  emit box.editingFinished();
  box.stepUp();
  EXPECT_EQ(scene.document.undoStack().count(), 2);
}

TEST(PropertyPanel, ShowsAndSetsPlaceSizeAndRotation) {
  EditedScene scene(kTwoWalls);
  PropertyPanel panel(scene.document);
  ASSERT_TRUE(scene.select("right"));
  EXPECT_NEAR(field(panel, "positionXField").value(), 10, 0.01);
  EXPECT_NEAR(field(panel, "sizeYField").value(), 10, 0.01);
  field(panel, "positionYField").setValue(5);
  field(panel, "sizeXField").setValue(3);
  field(panel, "rotationField").setValue(90);
  letEventsRun();
  const Shape& shape = scene.document.compiled().scene->walls[1].shape;
  EXPECT_TRUE(shape.centre.isApprox(Vector3(0.1, 0.05, 0), 1e-5));
  EXPECT_TRUE(shape.axes.col(0).isApprox(Vector3(0, 0.015, 0), 1e-4));
  EXPECT_EQ(scene.document.undoStack().count(), 3);
}

TEST(PropertyPanel, ChangesOnlyTheSelectedWallUnlessToldOtherwise) {
  EditedScene scene(kSharedProperty);
  PropertyPanel panel(scene.document);
  panel.show();
  ASSERT_TRUE(scene.select("maze (1)"));
  EXPECT_TRUE(field<QCheckBox>(panel, "onlyThisBox").isVisible());
  EXPECT_THAT(field<QLabel>(panel, "selectionHint").text().toStdString(), testing::HasSubstr("3 shapes share"));
  field(panel, "stiffnessField").setValue(500);
  letEventsRun();
  EXPECT_EQ(stiffness(scene, 0), 500);
  EXPECT_EQ(stiffness(scene, 1), 1200);
  EXPECT_FALSE(field<QCheckBox>(panel, "onlyThisBox").isVisible()) << "its values are its own now";

  ASSERT_TRUE(scene.select("maze (2)"));
  field<QCheckBox>(panel, "onlyThisBox").setChecked(false);
  field(panel, "stiffnessField").setValue(700);
  letEventsRun();
  EXPECT_EQ(stiffness(scene, 1), 700);
  EXPECT_EQ(stiffness(scene, 2), 700);
}

TEST(PropertyPanel, EditsToolAndDevice) {
  EditedScene scene(kTwoWalls);
  PropertyPanel panel(scene.document);
  ASSERT_TRUE(scene.select("ball"));
  field(panel, "massField").setValue(3.5);
  field(panel, "homeXField").setValue(2);
  ASSERT_TRUE(scene.select("vishard10"));
  field(panel, "orientationField").setValue(90);
  letEventsRun();
  const HapticScene& compiled = *scene.document.compiled().scene;
  EXPECT_EQ(compiled.tool.mass, 3.5);
  EXPECT_NEAR(compiled.tool.home.x(), 0.02, 1e-6);
  EXPECT_TRUE(compiled.device.rotation.col(0).isApprox(Vector3::UnitY(), 1e-5));
  EXPECT_TRUE(compiled.device.position.isApprox(Vector3(-0.6, 0, 0), 1e-6));
}

TEST(PropertyPanel, RenamesAWallInTheTreeToo) {
  EditedScene scene(kTwoWalls);
  PropertyPanel panel(scene.document);
  SceneTree tree(scene.document);
  ASSERT_TRUE(scene.select("left"));
  auto& line = field<QLineEdit>(panel, "labelField");
  EXPECT_EQ(line.text(), "left");
  line.setText("entrance");
  emit line.editingFinished();
  letEventsRun();
  EXPECT_TRUE(rowNamed(tree, "entrance"));
  EXPECT_FALSE(rowNamed(tree, "left"));
  emit line.editingFinished();
  EXPECT_EQ(scene.document.undoStack().count(), 1) << "nothing was changed the second time";
}

}  // namespace
}  // namespace haptiv
