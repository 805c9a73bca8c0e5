#include "app/calibration/CalibrationGuide.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/calibration/BrakedDevice.h"
#include "device/calibration/CalibrationRefused.h"
#include "device/simulated/Miscalibration.h"

namespace haptiv {
namespace {

using testing::HasSubstr;

struct Guide : testing::Test {
  DeviceDescription known = loadDeviceDescription("vishard10");
  BrakedDevice device = BrakedDevice::simulated(known, 2);
  CalibrationGuide guide{known};

  std::string step(bool anew = false) {
    device.handle()->hang(guide.load());
    device.measure(BrakedDevice::kSettle);
    return guide.take(device.measure(1000), anew);
  }
};

TEST_F(Guide, LeadsThroughAllStepsToACalibratedDescription) {
  const DeviceDescription built = miscalibrated(known, 2);
  EXPECT_THAT(step(), HasSubstr("zeros are found"));
  EXPECT_THAT(step(), HasSubstr("bias is found"));
  for (int load = 1; load < 12; ++load) EXPECT_THAT(step(), HasSubstr("Load " + std::to_string(load)));
  EXPECT_THAT(step(), HasSubstr("matrix is found"));
  EXPECT_EQ(guide.step(), GuideStep::finish);
  EXPECT_THAT(guide.summary(), HasSubstr("Encoders"));
  const DeviceDescription found = parseDeviceDescription(guide.calibration().text("vishard10"), "found");
  EXPECT_LT((found.sensor.bias - built.sensor.bias).norm(), 0.02);
  EXPECT_LT((found.sensor.matrix - built.sensor.matrix).diagonal().cwiseAbs().maxCoeff(), 2e-3);
  EXPECT_LT((found.encoders.zero - built.encoders.zero).cwiseAbs().maxCoeff(), 50);
}

TEST_F(Guide, StaysAtAStepThatIsRefused) {
  device.handle()->hang(Vector6::Unit(0));
  guide.skip();
  QuietMeasurement disturbed(1000);
  for (int i = 0; !disturbed.isDone(); ++i) {
    device.handle()->hang(i / 50 % 2 * Vector6::Unit(0));
    disturbed.take(device.tick());
  }
  EXPECT_THROW(guide.take(disturbed), CalibrationRefused);
  EXPECT_EQ(guide.step(), GuideStep::bias);
  EXPECT_FALSE(guide.calibration().isChanged());
  EXPECT_EQ(guide.calibration().text("vishard10"), known.text);
}

TEST_F(Guide, BeginsTheLoadsAnewWhereTogetherTheyAreRefused) {
  CalibrationGuide lazy(known, std::vector<Vector6>(8, 10 * Vector6::Unit(0)));
  lazy.skip();
  lazy.skip();
  for (int load = 1; load < 8; ++load) lazy.take(device.measure(1000));
  EXPECT_THROW(lazy.take(device.measure(1000)), CalibrationRefused);
  EXPECT_EQ(lazy.step(), GuideStep::loads);
  EXPECT_THAT(lazy.title(), HasSubstr("load 1 of 8"));
}

TEST_F(Guide, TellsWhatToHang) {
  guide.skip();
  EXPECT_EQ(guide.load(), Vector6(Vector6::Zero()));
  guide.skip();
  EXPECT_THAT(guide.instruction(), HasSubstr("+10 N of force x"));
}

}  // namespace
}  // namespace haptiv
