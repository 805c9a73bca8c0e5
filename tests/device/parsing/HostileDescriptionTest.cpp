#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "device/kinematics/ArmKinematics.h"
#include "tests/device/parsing/Refusal.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(HostileDescription, NestingIsRefusedHoweverDeep) {
  for (const std::string& toml :
       {"schema = 1\n" + repeated("a.", 300000) + "a = 1\n", "schema = 1\n[" + repeated("a . ", 300000) + "a]\n",
        "schema = 1\n" + repeated("'a'.", 300000) + "a = 1\n", "schema = 1\na = " + repeated("[", 300000),
        "schema = 1\na = " + repeated("{a = ", 300000),
        "schema = 1\na = {b = '#', " + repeated("a.", 300000) + "a = 1}\n"})
    EXPECT_THAT(refusal(toml), StartsWith("arm.toml:2:"));
}

TEST(HostileDescription, HugeListsAreRefused) {
  EXPECT_THAT(refusal("schema = 1\n[drives]\ngearRatio = [" + repeated("1,", 200000) + "1]\n"),
              AllOf(StartsWith("arm.toml:3:13: "), HasSubstr("200001 entries; give 10")));
  EXPECT_THAT(refusal("schema = 1\n[redundancy]\nnormalisationPoses = [" + repeated("[],", 1000) + "]\n"),
              AllOf(StartsWith("arm.toml:3:22: "), HasSubstr("100 poses")));
  EXPECT_THAT(refusal("schema = 1\n" + repeated("[[chain.joint]]\n", 20000)), HasSubstr("at most 10 joints"));
}

TEST(HostileDescription, NumbersThatAreNoneAreRefused) {
  for (const char* number : {"nan", "-nan", "inf", "1e999", "99999999999999999999", "9223372036854775807", "1e10",
                             "-1e300", "0x1p3", "true", "1979-05-27", "'1'", "[1]", "{a = 1}", ""})
    EXPECT_THAT(refusal(std::string("schema = 1\n[control]\njointGain = ") + number + "\n"), StartsWith("arm.toml:"))
        << number;
}

TEST(HostileDescription, NamesAreToldShortAndWithoutWhatATerminalWouldObey) {
  const std::string message = refusal("schema = 1\n[links]\n\"\\u001b[31m" + repeated("x", 10000) + "\" = 1\n");
  EXPECT_THAT(message, AllOf(StartsWith("arm.toml:3:1: "), Not(HasSubstr("\x1b"))));
  EXPECT_LT(message.size(), 300u);
  EXPECT_THAT(refusal("schema = 1\nname = \"\\u001b[31m\"\n"), StartsWith("arm.toml:2:8: "));
  EXPECT_THAT(refusal("schema = 1\nname = '" + repeated("x", 10000) + "'\n"), StartsWith("arm.toml:2:8: "));
}

TEST(HostileDescription, AFileThatIsTooLargeIsNotRead) {
  const auto path = std::filesystem::temp_directory_path() / "haptiv-large-description.toml";
  std::ofstream(path) << "schema = 1\n" << repeated("# nothing here\n", 100000);
  std::string message;
  try {
    loadDeviceDescription(path.string());
  } catch (const std::runtime_error& error) {
    message = error.what();
  }
  std::filesystem::remove(path);
  EXPECT_THAT(message, HasSubstr("1 MB"));
}

/// Cuts, doubles and changes pieces of a good file: it is refused with a place, or the arm has finite kinematics.
TEST(HostileDescription, AnyDamageIsRefusedOrHarmless) {
  test::Random random(1);
  for (const char* name : {"vishard10", "anthropomorphic7", "falcon"}) {
    const std::string good = loadDeviceDescription(name).text;
    const std::string pieces = "[]{}=.,'\"#-+eE019nai \n";
    for (int i = 0; i < 1000; ++i) {
      std::string bad = good;
      for (int change = 0; change < 3; ++change) {
        const auto at = static_cast<std::size_t>(random.between(0, static_cast<double>(bad.size())));
        if (random.between(0, 1) < 0.3)
          bad.erase(at, 1 + static_cast<std::size_t>(random.between(0, 40)));
        else
          bad.insert(at, 1, pieces[static_cast<std::size_t>(random.between(0, static_cast<double>(pieces.size())))]);
      }
      try {
        const DeviceDescription d = parseDeviceDescription(bad, "arm.toml");
        const ArmPose arm = ArmKinematics(d).evaluate(d.homeAngles);
        EXPECT_TRUE(arm.X_BT.position.allFinite() && arm.J_BT.allFinite()) << bad;
      } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), StartsWith("arm.toml:"));
      }
    }
  }
}

}  // namespace
}  // namespace haptiv
