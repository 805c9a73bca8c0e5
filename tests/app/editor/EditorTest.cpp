#include "app/editor/Editor.h"

#include <gmock/gmock.h>

#include <QTest>

#include "app/editor/panels/NumberField.h"
#include "tests/app/editor/EditedScene.h"

namespace haptiv {
namespace {

/// Everything in a window, as the application has it.
class EditorInAWindow : public testing::Test {
 protected:
  EditorInAWindow() : scene(kTwoWalls), view(new SceneView(&window)), editor(scene.document, *view) {
    view->setScene(scene.document.root(), true);
    editor.propertyPanel()->setParent(&window);
    for (QAction* action : {editor.undo(), editor.redo(), editor.addWall(), editor.addDampingZone(),
                            editor.addSpringZone(), editor.remove()}) {
      window.addAction(action);
    }
  }
  void show() {
    window.resize(900, 600);
    view->setGeometry(280, 0, 620, 600);
    editor.propertyPanel()->setGeometry(0, 0, 280, 600);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    letEventsRun();
  }

  EditedScene scene;
  QWidget window;
  SceneView* view;
  Editor editor;
};

TEST_F(EditorInAWindow, OffersOnlyWhatCanBeDone) {
  EXPECT_FALSE(editor.undo()->isEnabled());
  EXPECT_FALSE(editor.remove()->isEnabled());
  EXPECT_TRUE(editor.addWall()->isEnabled());
  editor.addWall()->trigger();
  letEventsRun();
  EXPECT_TRUE(editor.undo()->isEnabled());
  EXPECT_TRUE(editor.remove()->isEnabled());
  EXPECT_EQ(editor.undo()->text(), "&Undo new wall 1");
  editor.remove()->trigger();
  letEventsRun();
  EXPECT_FALSE(editor.remove()->isEnabled());
  editor.setEnabled(false);
  EXPECT_FALSE(editor.undo()->isEnabled());
  EXPECT_FALSE(editor.addWall()->isEnabled());
  EXPECT_FALSE(editor.propertyPanel()->isEnabled());
}

TEST_F(EditorInAWindow, WorksByKeys) {
  show();
  QTest::keyClick(&window, Qt::Key_W);
  QTest::keyClick(&window, Qt::Key_D);
  QTest::keyClick(&window, Qt::Key_S);
  letEventsRun();
  EXPECT_EQ(scene.document.compiled().scene->walls.size(), 3u);
  EXPECT_EQ(scene.document.compiled().scene->zones.size(), 2u);
  QTest::keyClick(&window, Qt::Key_Delete);
  QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
  QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
  letEventsRun();
  EXPECT_EQ(scene.document.compiled().scene->zones.size(), 1u);
  QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  letEventsRun();
  EXPECT_EQ(scene.document.compiled().scene->zones.size(), 2u);
}

TEST_F(EditorInAWindow, UndoesATypedStiffnessWhileTheFieldHasTheKeyboard) {
  show();
  ASSERT_TRUE(scene.select("left"));
  auto* box = editor.propertyPanel()->findChild<NumberField*>("stiffnessField");
  ASSERT_TRUE(box);
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, "3000");
  EXPECT_EQ(scene.document.undoStack().count(), 0) << "not while typing";
  QTest::keyClick(box, Qt::Key_Return);
  letEventsRun();
  EXPECT_EQ(scene.document.compiled().scene->walls[0].surface.stiffness, 3000);
  QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
  letEventsRun();
  EXPECT_EQ(scene.document.compiled().scene->walls[0].surface.stiffness, 1500);
  EXPECT_EQ(box->value(), 1500);
}

TEST_F(EditorInAWindow, SelectsWhatIsClicked) {
  show();
  view->viewFromAbove();
  view->viewAll();
  QTest::qWait(200);  // for the first frame, by which the view knows its size
  const QPoint left = view->toWidget({-0.1, 0, 0.02}).toPoint();
  QWidget* canvas = view->childAt(left);
  ASSERT_TRUE(canvas);
  QTest::mouseClick(canvas, Qt::LeftButton, Qt::NoModifier, canvas->mapFrom(view, left));
  letEventsRun();
  const std::vector<SceneItem> items = scene.items();
  const SceneItem* item = findItem(items, scene.document.selection());
  ASSERT_TRUE(item);
  EXPECT_EQ(item->name, "left");
}

}  // namespace
}  // namespace haptiv
