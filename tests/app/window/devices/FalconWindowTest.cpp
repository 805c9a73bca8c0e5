// A Falcon in the window: its firmware, its homing, a session with it.
#include <gmock/gmock.h>

#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>

#include "tests/app/window/devices/BusWindow.h"

namespace haptiv {
namespace {

using testing::waitFor;

class FalconWindow : public BusWindow {
 protected:
  void SetUp() override {
    Window::SetUp();
    plugFalcon();
    window_->open(HAPTIV_SOURCE_DIR "/scenes/falcon-wall.iv");
    choose("deviceMenu", "falcon:FALCON-1DeviceAction");
  }
  QString write(const char* name, const QByteArray& bytes) {
    QFile file(home_.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
    return file.fileName();
  }
  /// In the dialog that is open.
  void chooseFile(const QString& path) {
    auto& dialog = find<QFileDialog>("firmwareDialog");
    dialog.selectFile(path);
    QMetaObject::invokeMethod(&dialog, "accept");
    QTest::qWait(50);
  }
  QString messageOnce() {
    EXPECT_TRUE(waitFor([&] { return window_->findChild<QMessageBox*>("messageBox") != nullptr; }));
    auto& box = find<QMessageBox>("messageBox");
    const QString text = box.text();
    box.accept();
    QTest::qWait(50);
    return text;
  }
  QString kept() const { return home_.filePath(".local/share/haptiv/falcon.bin"); }

  const QByteArray firmware_ = QByteArray(4096, '\x7f');
};

TEST_F(FalconWindow, WithoutAFirmwareTheWayToOneIsInTheMessage) {
  const test::RunningBus runs(bus_);
  clickButton("startAction");
  EXPECT_TRUE(waitFor([&] { return window_->findChild<QMessageBox*>("messageBox") != nullptr; }));
  auto& box = find<QMessageBox>("messageBox");
  EXPECT_TRUE(box.text().contains("no such firmware file")) << box.text().toStdString();
  picture("falcon-no-firmware");
  QTest::mouseClick(box.findChild<QPushButton*>("chooseFirmware"), Qt::LeftButton);
  EXPECT_TRUE(waitFor([&] { return window_->findChild<QFileDialog*>("firmwareDialog") != nullptr; }));
  chooseFile(write("novint.bin", firmware_));
  EXPECT_TRUE(QFile::exists(kept()));
  EXPECT_TRUE(find<QAction>("startAction").isEnabled());
}

TEST_F(FalconWindow, AWrongFirmwareFileIsToldAndTheOneBeforeStays) {
  find<QAction>("firmwareAction").trigger();
  chooseFile(write("novint.bin", firmware_));
  for (const auto& [name, bytes] : {std::pair("readme.txt", QByteArray(5000, 'a')), {"short.bin", QByteArray(9, 1)}}) {
    find<QAction>("firmwareAction").trigger();
    chooseFile(write(name, bytes));
    auto& box = find<QMessageBox>("messageBox");
    EXPECT_TRUE(box.text().contains(name)) << box.text().toStdString();
    picture(name);
    box.accept();
    QTest::qWait(50);
  }
  QFile file(kept());
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_EQ(file.readAll(), firmware_);
}

TEST_F(FalconWindow, IsHomedByTheOperatorAndFeltAndStoppedByEsc) {
  find<QAction>("firmwareAction").trigger();
  chooseFile(write("novint.bin", firmware_));
  falcon().faults().homesByItself = false;
  const test::RunningBus runs(bus_);
  clickButton("startAction");
  auto& dialog = find<QProgressDialog>("falconDialog");
  EXPECT_TRUE(waitFor([&] { return dialog.labelText().contains("pull the grip"); }, 30'000));
  EXPECT_FALSE(find<QAction>("startAction").isEnabled());
  picture("falcon-homing");
  falcon().faults().operatorHomes = true;
  EXPECT_TRUE(waitFor([&] { return find<QAction>("stopAction").isEnabled(); }, 30'000));
  const QLabel& state = find<QLabel>("modeLabel");
  EXPECT_TRUE(waitFor([&] { return state.text() == "Ready"; }));
  EXPECT_TRUE(find<QLabel>("hintLabel").text().contains("dead-man")) << find<QLabel>("hintLabel").text().toStdString();
  falcon().setButtons(falcon::Logic::kDeadManButton);
  EXPECT_TRUE(waitFor([&] { return state.text() == "Running"; }));
  picture("falcon-running");
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_TRUE(waitFor([&] { return state.text().contains("emergency stop"); })) << state.text().toStdString();
  EXPECT_TRUE(waitFor([&] { return falcon().lastOrder().motors == falcon::Order{}.motors; }));
  picture("falcon-stopped");
  stopSession();
  EXPECT_EQ(state.text(), "Replay") << "its log is whole";
}

TEST_F(FalconWindow, CancelledWhileItIsHomedAllIsAsBefore) {
  find<QAction>("firmwareAction").trigger();
  chooseFile(write("novint.bin", firmware_));
  falcon().faults().homesByItself = false;
  const test::RunningBus runs(bus_);
  clickButton("startAction");
  auto& dialog = find<QProgressDialog>("falconDialog");
  EXPECT_TRUE(waitFor([&] { return dialog.labelText().contains("pull the grip"); }, 30'000));
  emit dialog.canceled();
  EXPECT_TRUE(waitFor([&] { return find<QAction>("startAction").isEnabled(); }));
  EXPECT_EQ(window_->findChild<QMessageBox*>("messageBox"), nullptr) << "nothing went wrong";
  EXPECT_FALSE(find<QAction>("stopAction").isEnabled());
  falcon().faults().homesByItself = true;
  clickButton("startAction");
  EXPECT_TRUE(waitFor([&] { return find<QAction>("stopAction").isEnabled(); }, 30'000)) << "and it can be started anew";
  stopSession();
}

TEST_F(FalconWindow, OfASceneForAnotherArmIsRefused) {
  openScene(kNoWalls);
  clickButton("startAction");
  EXPECT_TRUE(messageOnce().contains("vishard10"));
  EXPECT_TRUE(find<QAction>("startAction").isEnabled());
}

}  // namespace
}  // namespace haptiv
