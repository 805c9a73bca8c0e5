#include <gmock/gmock.h>

#include <QLabel>

#include "app/editor/edits/Edits.h"
#include "tests/app/editor/EditedScene.h"
#include "tests/app/editor/panels/PanelWidgets.h"

namespace haptiv {
namespace {

TEST(SceneTree, GroupsByKindWithCounts) {
  EditedScene scene(kTwoWalls);
  SceneTree tree(scene.document);
  addShape(scene.document, SceneItem::Kind::dampingZone);
  letEventsRun();
  EXPECT_TRUE(rowNamed(tree, "Walls (2)"));
  EXPECT_TRUE(rowNamed(tree, "Damping zones (1)"));
  EXPECT_TRUE(rowNamed(tree, "Spring zones (0)"));
  ASSERT_TRUE(tree.currentItem());
  EXPECT_EQ(tree.currentItem()->text(0), "damping zone 1");
}

TEST(SceneTree, SelectsInTheDocumentAndFollowsIt) {
  EditedScene scene(kTwoWalls);
  SceneTree tree(scene.document);
  PropertyPanel panel(scene.document);
  tree.setCurrentItem(rowNamed(tree, "left"));
  letEventsRun();
  ASSERT_TRUE(scene.document.selection());
  EXPECT_EQ(field<QLabel>(panel, "selectionName").text(), "left");
  EXPECT_EQ(field(panel, "stiffnessField").value(), 1500);
  ASSERT_TRUE(scene.select("right"));
  EXPECT_EQ(tree.currentItem(), rowNamed(tree, "right"));
  scene.document.select(nullptr);
  letEventsRun();
  EXPECT_EQ(tree.currentItem(), nullptr);
}

}  // namespace
}  // namespace haptiv
