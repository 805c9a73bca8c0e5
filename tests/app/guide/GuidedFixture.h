#pragma once

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <memory>
#include <stdexcept>
#include <string>

#include "app/guide/CalibrationDialog.h"
#include "tests/app/window/Gestures.h"

namespace haptiv {

/// The dialog as a user walks through it, with a simulated arm that is not quite as described.
class Guided : public ::testing::Test {
 protected:
  static constexpr std::uint64_t kSeed = 3;

  void open(const DeviceOpener& opener = [](const DeviceDescription& d) { return BrakedDevice::simulated(d, kSeed); }) {
    dialog_ = std::make_unique<CalibrationDialog>(known_, "vishard10", opener);
    dialog_->setMeasuringTime(0.42);
    dialog_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog_.get()));
  }
  template <typename T>
  T& find(const char* name) {
    T* found = dialog_->findChild<T*>(name);
    if (found == nullptr) throw std::runtime_error(std::string("the dialog has no ") + name);
    return *found;
  }
  QString text(const char* label) { return find<QLabel>(label).text(); }
  void click(const char* button) {
    auto& widget = find<QPushButton>(button);
    ASSERT_TRUE(widget.isVisible() && widget.isEnabled()) << button;
    QTest::mouseClick(&widget, Qt::LeftButton);
  }
  /// Measures, until the button can be pressed again or the last page is there.
  void measure() {
    click("guideMeasure");
    EXPECT_FALSE(find<QPushButton>("guideMeasure").isEnabled());
    ASSERT_TRUE(testing::waitFor([&] { return find<QPushButton>("guideMeasure").isEnabled(); }, 60'000));
  }
  /// For people to look at: HAPTIV_PICTURES names a folder.
  void picture(const char* name) {
    if (qEnvironmentVariableIsSet("HAPTIV_PICTURES"))
      (QApplication::activeModalWidget() != nullptr ? QApplication::activeModalWidget() : dialog_.get())
          ->grab()
          .save(qEnvironmentVariable("HAPTIV_PICTURES") + "/" + name + ".png");
  }

  DeviceDescription known_ = loadDeviceDescription("vishard10");
  QTemporaryDir folder_;
  std::unique_ptr<CalibrationDialog> dialog_;
};

}  // namespace haptiv
