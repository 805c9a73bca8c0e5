#include "device/parsing/KeyEdit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "device/parsing/CalibratedText.h"
#include "device/simulated/Miscalibration.h"

namespace haptiv {
namespace {

using testing::HasSubstr;

std::string edited(std::string_view toml, const std::string& value = "[1, 2]") {
  return withKeys(toml, {{"sensor", "bias", value}}, "arm.toml");
}

TEST(KeyEdit, ReplacesTheValueOfAKeyAndNothingElse) {
  EXPECT_EQ(edited("# top\n[sensor]  # six axes\nbias = [0, 0]   # old\nx = 1\n"),
            "# top\n[sensor]  # six axes\nbias = [1, 2]   # old\nx = 1\n");
  EXPECT_EQ(edited("[sensor]\nbias = [\n  0,  # one\n  0,\n]\nx = 1"), "[sensor]\nbias = [1, 2]\nx = 1");
  EXPECT_EQ(edited("sensor.bias = 3\nx = 1\n"), "sensor.bias = [1, 2]\nx = 1\n");
  EXPECT_EQ(edited("sensor = {bias = 3, x = 1}\n"), "sensor = {bias = [1, 2], x = 1}\n");
}

TEST(KeyEdit, PutsANewKeyBelowItsSectionsHead) {
  EXPECT_EQ(edited("[sensor] # six\nx = 1\n[b]\n"), "[sensor] # six\nbias = [1, 2]\nx = 1\n[b]\n");
  EXPECT_EQ(edited("[sensor]"), "[sensor]\nbias = [1, 2]\n");
}

TEST(KeyEdit, PutsANewSectionAtTheEnd) {
  EXPECT_EQ(edited("x = 1\n[[link]]\ny = 2"), "x = 1\n[[link]]\ny = 2\n\n[sensor]\nbias = [1, 2]\n");
  EXPECT_EQ(edited("x = 1\n"), "x = 1\n\n[sensor]\nbias = [1, 2]\n");
}

TEST(KeyEdit, KeepsLineEndsAndCountsWhatIsNoAscii) {
  EXPECT_EQ(edited("# \xc3\xa4\xe2\x82\xac\r\n[sensor]\r\nx = 1\r\n"),
            "# \xc3\xa4\xe2\x82\xac\r\n[sensor]\r\nbias = [1, 2]\r\nx = 1\r\n");
  EXPECT_EQ(edited("sensor = {n = \"\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80\", bias = 3}  # \xc3\xa4\n"),
            "sensor = {n = \"\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80\", bias = [1, 2]}  # \xc3\xa4\n");
  EXPECT_EQ(edited("\xef\xbb\xbfsensor.bias = 3\n"), "\xef\xbb\xbfsensor.bias = [1, 2]\n");
}

TEST(KeyEdit, RefusesWhatItCannotAddTo) {
  for (const char* toml :
       {"sensor = {x = 1}\n", "sensor.x = 1\n", "sensor = 3\n", "[sensor\n", "[sensor.part]\nx = 1\n"}) {
    std::string after;
    try {
      after = edited(toml);
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("arm.toml")) << toml;
      continue;
    }
    EXPECT_THAT(after, HasSubstr("bias = [1, 2]")) << toml;  // and parses: withKeys has looked
  }
}

TEST(CalibratedText, OfTheBuiltInDescriptionKeepsEveryLineAndComesBack) {
  DeviceDescription calibrated = loadDeviceDescription("vishard10");
  const DeviceDescription built = miscalibrated(calibrated, 4);
  calibrated.sensor = built.sensor;
  calibrated.encoders = built.encoders;
  const std::string text = calibratedText(calibrated, "arm.toml");
  const DeviceDescription again = parseDeviceDescription(text, "arm.toml");
  EXPECT_TRUE(again.sensor.bias.isApprox(built.sensor.bias, 1e-5));
  EXPECT_TRUE(again.sensor.matrix.isApprox(built.sensor.matrix, 1e-6));
  EXPECT_EQ(again.encoders.zero, built.encoders.zero);
  EXPECT_EQ(again.encoders.reference, calibrated.encoders.reference);
  std::istringstream before(calibrated.text), after(text);
  std::string wanted, line;
  while (std::getline(before, wanted)) {
    do {
      ASSERT_TRUE(std::getline(after, line)) << "lost: " << wanted;
    } while (line != wanted);
  }
}

TEST(CalibratedText, OfWhatHasNotChangedIsTheSame) {
  const DeviceDescription same = loadDeviceDescription("vishard10");
  EXPECT_EQ(calibratedText(same, "vishard10"), same.text);
}

TEST(CalibratedText, ThatWouldBeRefusedIsNotWritten) {
  DeviceDescription bad = loadDeviceDescription("vishard10");
  bad.sensor.matrix.setZero();
  EXPECT_THROW(calibratedText(bad, "arm.toml"), std::runtime_error);
}

}  // namespace
}  // namespace haptiv
