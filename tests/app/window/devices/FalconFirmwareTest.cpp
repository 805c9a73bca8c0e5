// The Falcon's firmware file in the window: chosen, kept, refused.
#include <QPushButton>

#include "tests/app/window/devices/FalconWindow.h"

namespace haptiv {
namespace {

using testing::waitFor;

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
  keepFirmware();
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

}  // namespace
}  // namespace haptiv
