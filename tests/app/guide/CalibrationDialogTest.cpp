/// The dialog as a user walks through it, with a simulated arm that is not quite as described.
#include "app/guide/CalibrationDialog.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTemporaryDir>
#include <stdexcept>

#include "device/simulated/Miscalibration.h"
#include "device/simulated/SimulatedDevice.h"
#include "tests/app/guide/GuidedFixture.h"

namespace haptiv {
namespace {

using testing::waitFor;

TEST_F(Guided, FindsZerosBiasAndMatrixAndSavesThem) {
  open();
  EXPECT_TRUE(waitFor([&] { return text("axis1") != "-"; })) << "live readings";
  picture("pose");
  measure();
  EXPECT_TRUE(text("guideResult").contains("zeros are found")) << text("guideResult").toStdString();
  EXPECT_TRUE(text("guideTitle").contains("bias"));
  measure();
  EXPECT_TRUE(text("guideResult").contains("bias is found")) << text("guideResult").toStdString();
  picture("loads");
  for (int load = 1; load <= 12; ++load) {
    EXPECT_TRUE(text("guideTitle").contains(QString("load %1 of 12").arg(load))) << text("guideTitle").toStdString();
    measure();
  }
  EXPECT_TRUE(text("guideResult").contains("matrix is found")) << text("guideResult").toStdString();
  picture("save");
  const QString path = folder_.filePath("mine.toml");
  find<QLineEdit>("guidePath").setText(path);
  click("guideSave");
  picture("saved");
  EXPECT_TRUE(text("guideResult").contains(path));

  const DeviceDescription saved = loadDeviceDescription(path.toStdString()), built = miscalibrated(known_, kSeed);
  EXPECT_LT((saved.sensor.bias - built.sensor.bias).head<3>().norm(), 0.05);
  EXPECT_LT((saved.sensor.matrix - built.sensor.matrix).diagonal().cwiseAbs().maxCoeff(), 5e-3);
  EXPECT_LT((saved.encoders.zero - built.encoders.zero).cwiseAbs().maxCoeff(), 50);
}

TEST_F(Guided, StepsCanBeLeftOutAndBegunAnew) {
  open();
  click("guideSkip");
  click("guideSkip");
  EXPECT_TRUE(text("guideTitle").contains("load 1 of 12"));
  measure();
  EXPECT_TRUE(text("guideTitle").contains("load 2 of 12"));
  click("guideSkip");
  EXPECT_TRUE(text("guideResult").contains("Nothing was measured")) << text("guideResult").toStdString();
  EXPECT_FALSE(find<QPushButton>("guideSave").isEnabled());
  picture("nothing");
  click("guideRestart");
  EXPECT_TRUE(text("guideTitle").contains("pose"));
  EXPECT_TRUE(find<QCheckBox>("guideAnew").isVisible());
}

TEST_F(Guided, SaysWhyAStepIsRefusedAndStays) {
  // Its arm stands where its home is; the reference pose of this description is elsewhere.
  known_.encoders.reference[3] += 0.7;
  open([](const DeviceDescription& d) {
    DeviceDescription elsewhere = d;
    elsewhere.encoders.reference = d.homeAngles;
    return BrakedDevice::simulated(elsewhere, kSeed);
  });
  measure();
  EXPECT_TRUE(text("guideResult").contains("oint 4 stands at")) << text("guideResult").toStdString();
  EXPECT_TRUE(text("guideTitle").contains("pose"));
  picture("refused");
  find<QCheckBox>("guideAnew").setChecked(true);
  measure();
  EXPECT_TRUE(text("guideTitle").contains("bias"));
}

TEST_F(Guided, SaysWhatADeviceThatDoesNotOpenLacks) {
  open([](const DeviceDescription&) -> BrakedDevice {
    throw std::runtime_error("no interface board is there; plug one in and switch it on");
  });
  EXPECT_TRUE(text("guideResult").contains("plug one in"));
  EXPECT_FALSE(find<QPushButton>("guideMeasure").isEnabled());
  EXPECT_TRUE(find<QPushButton>("guideClose").isEnabled());
  picture("no-device");
  click("guideClose");
  EXPECT_FALSE(dialog_->isVisible());
}

TEST_F(Guided, SaysWhatStandsInTheWayOfSaving) {
  open();
  measure();
  click("guideSkip");
  click("guideSkip");
  find<QLineEdit>("guidePath").setText(folder_.filePath("no/such/folder.toml"));
  click("guideSave");
  EXPECT_TRUE(text("guideResult").contains("cannot be written")) << text("guideResult").toStdString();
  picture("unwritten");
}

TEST_F(Guided, LeavesOutTheSensorOfADeviceThatHasNone) {
  known_ = loadDeviceDescription("falcon");
  open();
  EXPECT_FALSE(text("guideSteps").contains("Sensor"));
  measure();
  EXPECT_TRUE(text("guideTitle").contains("Save")) << text("guideTitle").toStdString();
}

TEST_F(Guided, FitsOnASmallScreen) {
  open();
  EXPECT_LE(dialog_->minimumSizeHint().width(), 1240);
  EXPECT_LE(dialog_->minimumSizeHint().height(), 680);
}

}  // namespace
}  // namespace haptiv
