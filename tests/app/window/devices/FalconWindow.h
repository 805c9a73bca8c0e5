#pragma once

#include <QFileDialog>
#include <QMessageBox>
#include <QProgressDialog>

#include "tests/app/window/devices/BusWindow.h"

namespace haptiv {

/// The window with a Falcon plugged in and chosen, and a scene for it.
class FalconWindow : public BusWindow {
 protected:
  ~FalconWindow() override { window_.reset(); }  // while the bus still runs: a session says its last word

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
  void keepFirmware() {
    find<QAction>("firmwareAction").trigger();
    chooseFile(write("novint.bin", firmware_));
  }
  /// Starts a session with a Falcon that the operator has to home, and waits until it asks for that.
  QProgressDialog& startUntilItAsks() {
    keepFirmware();
    falcon().faults().homesByItself = false;
    runs_ = std::make_unique<test::RunningBus>(bus_);
    clickButton("startAction");
    auto& dialog = find<QProgressDialog>("falconDialog");
    EXPECT_TRUE(testing::waitFor([&] { return dialog.labelText().contains("pull the grip"); }, 30'000));
    return dialog;
  }
  QString messageOnce() {
    EXPECT_TRUE(testing::waitFor([&] { return window_->findChild<QMessageBox*>("messageBox") != nullptr; }));
    auto& box = find<QMessageBox>("messageBox");
    const QString text = box.text();
    box.accept();
    QTest::qWait(50);
    return text;
  }
  QString kept() const { return home_.filePath(".local/share/haptiv/falcon.bin"); }

  const QByteArray firmware_ = QByteArray(4096, '\x7f');
  std::unique_ptr<test::RunningBus> runs_;
};

}  // namespace haptiv
