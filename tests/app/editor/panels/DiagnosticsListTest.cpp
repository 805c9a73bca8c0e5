#include "app/editor/panels/DiagnosticsList.h"

#include <gmock/gmock.h>

#include "app/editor/edits/Edits.h"
#include "tests/app/editor/EditedScene.h"

namespace haptiv {
namespace {

TEST(DiagnosticsList, SaysThatThereAreNoProblems) {
  EditedScene scene("#Inventor V2.1 ascii\nHapticTool { home 0.3 0 0 }\n");
  DiagnosticsList list(scene.document);
  ASSERT_EQ(list.count(), 1);
  EXPECT_EQ(list.item(0)->text(), "No problems");
}

TEST(DiagnosticsList, SelectsTheShapeThatIsMeant) {
  EditedScene scene(kTwoWalls);
  DiagnosticsList list(scene.document);
  ASSERT_TRUE(scene.select("left"));
  editProperty(
      scene.document, "stiffness", [](const SoField& f) { return FieldValue(f, "-1"); }, Reach::onlyThis);
  scene.document.select(nullptr);
  letEventsRun();
  ASSERT_EQ(list.count(), 1);
  EXPECT_THAT(list.item(0)->text().toStdString(), testing::HasSubstr("stiffness"));
  emit list.itemClicked(list.item(0));
  letEventsRun();
  const std::vector<SceneItem> items = scene.items();
  const SceneItem* item = findItem(items, scene.document.selection());
  ASSERT_TRUE(item);
  EXPECT_EQ(item->name, "left");
}

TEST(DiagnosticsList, ShowsWhatIsDoubtfulWithItsLineAndSelectsIt) {
  EditedScene scene(
      "#VRML V2.0 utf8\nHapticTool { home 0.3 0 0 }\nTransform { translation 0.3 0.2 0 children [ HapticSurface { "
      "label "
      "\"thin\" }\nShape { geometry Box { size 0.1 0.001 0.1 } } ] }\n");
  DiagnosticsList list(scene.document);
  ASSERT_EQ(list.count(), 1);
  EXPECT_THAT(list.item(0)->text().toStdString(), testing::StartsWith("Line 4: "));
  EXPECT_THAT(list.item(0)->text().toStdString(), testing::HasSubstr("1 mm thick"));
  EXPECT_NE(list.item(0)->icon().cacheKey(), 0);
  emit list.itemActivated(list.item(0));
  letEventsRun();
  const std::vector<SceneItem> items = scene.items();
  const SceneItem* item = findItem(items, scene.document.selection());
  ASSERT_TRUE(item);
  EXPECT_EQ(item->name, "thin");
  EXPECT_EQ(item->kind, SceneItem::Kind::wall);
}

TEST(DiagnosticsList, SelectsTheFirstOfASceneThatIsMeantAsAWhole) {
  EditedScene scene("#Inventor V2.1 ascii\n\nSeparator {\n HapticSurface { label \"wall\" }\n Cube { } }\n");
  DiagnosticsList list(scene.document);
  ASSERT_EQ(list.count(), 1);
  EXPECT_THAT(list.item(0)->text().toStdString(), testing::StartsWith("Line 3: Separator: the scene has no tool"));
  emit list.itemClicked(list.item(0));
  letEventsRun();
  const std::vector<SceneItem> items = scene.items();
  const SceneItem* item = findItem(items, scene.document.selection());
  ASSERT_TRUE(item);
  EXPECT_EQ(item->name, "wall");
}

TEST(DiagnosticsList, KnowsTheLinesOfWhatHasBeenSaved) {
  EditedScene scene(kTwoWalls);
  DiagnosticsList list(scene.document);
  ASSERT_TRUE(scene.select("left"));
  editProperty(
      scene.document, "stiffness", [](const SoField& f) { return FieldValue(f, "9e6"); }, Reach::onlyThis);
  scene.document.save(scene.pathOf("saved.iv"));
  letEventsRun();
  SceneDocument reopened;
  ASSERT_TRUE(reopened.open(scene.pathOf("saved.iv")));
  ASSERT_GT(list.count(), 0);
  ASSERT_EQ(reopened.diagnostics().size(), static_cast<std::size_t>(list.count()));
  for (int i = 0; i < list.count(); ++i) {
    const Diagnostic& again = reopened.diagnostics()[static_cast<std::size_t>(i)];
    EXPECT_GT(again.line, 0);
    EXPECT_EQ(list.item(i)->toolTip().toStdString(), toText(again));
  }
}

}  // namespace
}  // namespace haptiv
