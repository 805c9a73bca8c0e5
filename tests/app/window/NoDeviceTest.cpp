// The window where nothing is plugged in.
#include <QAction>
#include <QDialog>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "tests/app/window/WindowFixture.h"

namespace haptiv {
namespace {

using testing::waitFor;

TEST_F(Window, ASpaceMouseThatIsNotThereStartsNothingAndTheMouseDoes) {
  auto& menu = find<QMenu>("handMenu");
  EXPECT_TRUE(find<QAction>("mouseHandAction").isChecked());
  find<QAction>("spaceMouseVelocityAction").trigger();
  clickButton("startAction");
  EXPECT_TRUE(waitFor([&] { return window_->findChild<QMessageBox*>("messageBox") != nullptr; }));
  auto& box = find<QMessageBox>("messageBox");
  EXPECT_TRUE(box.text().contains("SpaceMouse")) << box.text().toStdString();
  box.accept();
  EXPECT_FALSE(find<QAction>("stopAction").isEnabled());
  find<QAction>("mouseHandAction").trigger();
  startSession();
  EXPECT_FALSE(menu.isEnabled()) << "not while a session runs";
}

TEST_F(Window, OffersTheSimulatedArmAndSaysThatNoBoardIsPluggedIn) {
  auto& menu = find<QMenu>("deviceMenu");
  emit menu.aboutToShow();
  EXPECT_TRUE(find<QAction>("simDeviceAction").isChecked());
  EXPECT_TRUE(waitFor([&] {
    const QList<QAction*> items = menu.actions();
    return std::any_of(items.begin(), items.end(),
                       [](QAction* item) { return !item->isEnabled() && item->text().contains("None is plugged in"); });
  }));
  startSession();
  EXPECT_FALSE(menu.isEnabled()) << "not while a session runs";
}

TEST_F(Window, TheControlMenuLeadsToTheCalibration) {
  find<QAction>("calibrateAction").trigger();
  EXPECT_TRUE(waitFor([&] { return window_->findChild<QDialog*>("calibrationDialog") != nullptr; }));
  auto& dialog = find<QDialog>("calibrationDialog");
  EXPECT_TRUE(waitFor([&] { return dialog.findChild<QLabel*>("axis1")->text() != "-"; })) << "live readings";
  EXPECT_TRUE(dialog.windowTitle().contains("vishard10"));
  QTest::mouseClick(dialog.findChild<QPushButton*>("guideClose"), Qt::LeftButton);
  EXPECT_TRUE(waitFor([&] { return window_->findChild<QDialog*>("calibrationDialog") == nullptr; }));
}

}  // namespace
}  // namespace haptiv
