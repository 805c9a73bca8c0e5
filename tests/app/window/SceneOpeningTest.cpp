// What the window makes of scenes: good, empty, broken, without haptic nodes.
#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMessageBox>

#include "tests/app/window/WindowFixture.h"

namespace haptiv {
namespace {

using testing::waitFor;

TEST_F(Window, OffersToMakeAModelSolidAndDoesSo) {
  openScene("#VRML V2.0 utf8\nViewpoint { position 0 0 9 }\nShape { geometry Sphere { radius 2 } }\n");
  const auto* hint = window_->findChild<QLabel*>("hintLabel");
  ASSERT_TRUE(hint);
  EXPECT_TRUE(hint->text().contains("Make solid")) << hint->text().toStdString();
  clickButton("makeSolidAction");
  ASSERT_TRUE(waitFor([&] { return document().compiled().scene && document().compiled().scene->walls.size() == 1; }));
  EXPECT_FALSE(hint->text().contains("Make solid")) << hint->text().toStdString();
  EXPECT_TRUE(document().diagnostics().empty());
}

TEST_F(Window, CountsProblemsAndSaysWhatToDoInAnEmptyScene) {
  openScene(
      "#Inventor V2.1 ascii\nHapticTool { home 0.35 0 0 }\nTranslation { translation 0.35 0.2 0 }\n"
      "HapticSurface { stiffness 2000 } Cube { width 0.1 height 0.001 depth 0.1 }\n");
  EXPECT_EQ(find<QDockWidget>("problemsDock").windowTitle(), "Problems (1)");
  find<QAction>("newAction").trigger();
  QTest::qWait(100);
  EXPECT_EQ(find<QDockWidget>("problemsDock").windowTitle(), "Problems");
  EXPECT_TRUE(find<QLabel>("hintLabel").text().contains("add walls (W)"))
      << find<QLabel>("hintLabel").text().toStdString();
}

TEST_F(Window, ABrokenSceneIsToldAndTheOldOneStays) {
  openScene(kWallAhead);
  const QString path = home_.filePath("broken.iv");
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("#Inventor V2.1 ascii\nHapticTool { radius }\n");
  file.close();
  window_->open(path);
  auto& box = find<QMessageBox>("messageBox");
  EXPECT_TRUE(box.text().contains("broken.iv:2")) << box.text().toStdString();
  box.accept();
  EXPECT_EQ(document().compiled().scene->walls.size(), 1u);
  clickButton("startAction");
  EXPECT_TRUE(waitFor([&] { return find<QAction>("stopAction").isEnabled(); })) << "the old one cannot be felt";
}

}  // namespace
}  // namespace haptiv
