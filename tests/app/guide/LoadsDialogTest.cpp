// What the user has to hang on the handle is entered in the guide, judged, and calibrated by.
#include "app/guide/LoadsDialog.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QTableWidget>

#include "device/simulated/Miscalibration.h"
#include "tests/app/guide/GuidedFixture.h"

namespace haptiv {
namespace {

using testing::waitFor;

class OwnLoads : public Guided {
 protected:
  void openLoads() {
    open();
    click("guideSkip");
    measure();  // the bias: loads are measured from it
    click("guideLoads");
  }
  QTableWidget& table() { return find<QTableWidget>("loadsTable"); }
  void enter(const char* field, double number) { find<QDoubleSpinBox>(field).setValue(number); }
  void clear() {
    while (table().rowCount() > 0) click("loadsRemove");
  }
  /// A kilogramme each way, at the tool and 4 cm beside it.
  void enterWeights() {
    enter("weightMass", 1);
    for (int down = 0; down < 6; ++down) {
      find<QComboBox>("weightDown").setCurrentIndex(down);
      for (const char* axis : {"x", "y", "z"}) enter((std::string("weightPlace") + axis).c_str(), 0);
      click("weightAdd");
      enter(down < 2 ? "weightPlacex" : down < 4 ? "weightPlacey" : "weightPlacez", 0.04);
      click("weightAdd");
    }
  }
  bool canBeTaken() { return find<QPushButton>("loadsTake").isEnabled(); }
};

TEST_F(OwnLoads, OfWeightsAtPlacesFindTheMatrix) {
  openLoads();
  EXPECT_EQ(table().rowCount(), 12) << "the standard ones";
  clear();
  EXPECT_FALSE(canBeTaken());
  EXPECT_TRUE(text("loadsVerdict").contains("too few")) << text("loadsVerdict").toStdString();
  enterWeights();
  picture("own-loads");
  EXPECT_EQ(table().item(0, 2)->text(), "-9.80665");
  ASSERT_TRUE(canBeTaken()) << text("loadsVerdict").toStdString();
  click("loadsTake");
  EXPECT_TRUE(text("guideTitle").contains("load 1 of 12"));
  EXPECT_TRUE(text("guideInstruction").contains("-9.81 N of force z")) << text("guideInstruction").toStdString();
  for (int load = 1; load <= 12; ++load) measure();
  EXPECT_TRUE(text("guideResult").contains("matrix is found")) << text("guideResult").toStdString();
}

TEST_F(OwnLoads, ThatAreWrongAreToldAtOnceAndNotTaken) {
  openLoads();
  table().item(3, 4)->setText("0,4 Nm");
  EXPECT_TRUE(text("loadsVerdict").contains("Load 4, torque y: \"0,4 Nm\" is no number"))
      << text("loadsVerdict").toStdString();
  EXPECT_FALSE(canBeTaken());
  picture("wrong-load");
  table().item(3, 4)->setText("1e9");
  EXPECT_TRUE(text("loadsVerdict").contains("beyond what the sensor measures")) << text("loadsVerdict").toStdString();
  table().item(3, 4)->setText("nan");
  EXPECT_FALSE(canBeTaken());
  table().item(3, 4)->setText("0");
  EXPECT_TRUE(canBeTaken());
  for (int row = 0; row < table().rowCount(); ++row) table().item(row, 5)->setText("0");
  EXPECT_TRUE(text("loadsVerdict").contains("torque z")) << text("loadsVerdict").toStdString();
  EXPECT_FALSE(canBeTaken());
}

TEST_F(OwnLoads, CancelledTheOnesBeforeStay) {
  openLoads();
  clear();
  click("loadsCancel");
  EXPECT_TRUE(text("guideTitle").contains("load 1 of 12"));
}

TEST_F(OwnLoads, FitOnASmallScreen) {
  openLoads();
  EXPECT_LE(find<QDialog>("loadsDialog").minimumSizeHint().height(), 680);
}

}  // namespace
}  // namespace haptiv
