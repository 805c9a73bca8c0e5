#include "device/described/DeviceDescription.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include "tests/device/parsing/Refusal.h"

namespace haptiv {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST(DeviceDescription, BuiltInOnesAreTheFilesOfTheSources) {
  for (const std::string name : {"vishard10", "anthropomorphic7", "falcon"}) {
    std::ifstream file(HAPTIV_SOURCE_DIR "/device/descriptions/" + name + ".toml", std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    ASSERT_FALSE(text.empty());
    EXPECT_EQ(loadDeviceDescription(name).text, text);
    EXPECT_EQ(loadDeviceDescription(name).name, name);
  }
}

TEST(DeviceDescription, ComesBackFromItsOwnText) {
  const DeviceDescription built = loadDeviceDescription("vishard10");
  const DeviceDescription again = parseDeviceDescription(built.text, "log");
  EXPECT_EQ(again.text, built.text);
  EXPECT_EQ(again.name, "vishard10");
  EXPECT_EQ(again.homeAngles, built.homeAngles);
  EXPECT_EQ(again.drives.gearRatio, built.drives.gearRatio);
  EXPECT_EQ(again.drives.torqueLimit, built.drives.torqueLimit);
  EXPECT_EQ(again.drives.gearRatio[0], 160);
  EXPECT_EQ(again.drives.inertia[9], 0.02);
}

TEST(DeviceDescription, LoadsFromAPath) {
  const std::string path = HAPTIV_SOURCE_DIR "/device/descriptions/vishard10.toml";
  EXPECT_EQ(loadDeviceDescription(path).homeAngles, loadDeviceDescription("vishard10").homeAngles);
}

TEST(DeviceDescription, ARelativePathStartsAtTheFileThatNamesIt) {
  const std::string scene = HAPTIV_SOURCE_DIR "/device/scene.iv", path = "descriptions/vishard10.toml";
  EXPECT_EQ(loadDeviceDescription(path, scene).homeAngles, loadDeviceDescription("vishard10").homeAngles);
  EXPECT_THROW(loadDeviceDescription("vishard10.toml", scene), std::runtime_error);
}

TEST(DeviceDescription, IsNotReadFromOutsideOfTheFolderOfTheSceneThatNamesIt) {
  const std::string scene = ::testing::TempDir() + "scene.iv";
  for (const std::string name : {"/etc/passwd", "../../etc/passwd", "/dev/zero"}) {
    try {
      loadDeviceDescription(name, scene);
      ADD_FAILURE() << name;
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("outside of the folder of the scene")) << name;
    }
  }
}

TEST(DeviceDescription, KeepsDefaultsForMissingKeysButAsksForTheSchema) {
  EXPECT_EQ(parseDeviceDescription("schema = 1", "arm.toml").links.scara, LinkLengths{}.scara);
  EXPECT_THAT(refusal("name = 'arm'"), AllOf(StartsWith("arm.toml:1:1: "), HasSubstr("schema = 1")));
  EXPECT_THAT(refusal(""), StartsWith("arm.toml:1:1: "));
}

TEST(DeviceDescription, NamesTheBuiltInOnesWhenThereIsNoSuchDevice) {
  try {
    loadDeviceDescription("vishard11");
    FAIL() << "it was found";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("vishard11"), HasSubstr("vishard10")));
  }
}

TEST(DeviceDescription, DecodesCountsToRadiansAndNewtons) {
  const DeviceDescription d = loadDeviceDescription("vishard10");
  DeviceReading reading;
  reading.encoderCounts[0] = 160 * 4096;   // one turn of joint 1
  reading.encoderCounts[1] = -100 * 1024;  // a quarter turn back of joint 2
  reading.sensorCounts = {100, -200, 0, 1000, 0, -30000};
  const JointVector q = d.jointAngles(reading);
  EXPECT_NEAR(q[0], 2 * std::numbers::pi, 1e-14);
  EXPECT_NEAR(q[1], -std::numbers::pi / 2, 1e-14);
  EXPECT_EQ(q[2], 0);
  const Wrench wrench = d.handleWrench(reading);
  EXPECT_TRUE(wrench.force.isApprox(Vector3(2, -4, 0), 1e-14));
  EXPECT_TRUE(wrench.torque.isApprox(Vector3(1, 0, -30), 1e-14));
}

TEST(DeviceDescription, TakesBiasCrosstalkAndZeroOutOfTheCounts) {
  const DeviceDescription d = parseDeviceDescription(
      "schema = 1\n[sensor]\nforceResolution = 0.5\ntorqueResolution = 0.25\nbias = [1, 2, 3, 4, 5, 6]\nmatrix = "
      "[[2,0,0,0,0,1],[0,1,0,0,0,0],[0,0,1,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,0,1]]\n"
      "[drives]\ngearRatio = [1,1,1,1,1,1,1,1,1,1]\n[encoders]\nzero = [1024,0,0,0,0,0,0,0,0,-1024]\n",
      "arm.toml");
  DeviceReading reading;
  reading.sensorCounts = {10, 4, 6, 16, 20, 48};  // 5, 2, 3 N; 4, 5, 12 N m
  reading.encoderCounts[0] = 2048;
  EXPECT_EQ(d.handleWrench(reading).force, Vector3(2 * 4 + 6, 0, 0));
  EXPECT_EQ(d.handleWrench(reading).torque, Vector3(0, 0, 6));
  const JointVector q = d.jointAngles(reading);
  EXPECT_NEAR(q[0], std::numbers::pi / 2, 1e-14);
  EXPECT_NEAR(q[9], std::numbers::pi / 2, 1e-14);
  EXPECT_EQ(d.countsAt(q), reading.encoderCounts);
}

TEST(DeviceDescription, HasItsHomeForAReferencePoseWhereItNamesNone) {
  const DeviceDescription d = loadDeviceDescription("vishard10");
  EXPECT_EQ(d.encoders.reference, d.homeAngles);
  EXPECT_EQ(d.encoders.zero, JointVector(JointVector::Zero()));
}

TEST(DeviceDescription, GivesGearsAndRatesOfThePapersDrives) {
  const DeviceDescription d = loadDeviceDescription("vishard10");
  for (int i = 0; i < kJointCount; ++i) {
    EXPECT_EQ(d.drives.countsPerTurn[i], 4096);
    EXPECT_GE(d.drives.gearRatio[i], 100);
    EXPECT_LE(d.drives.gearRatio[i], 160);
    EXPECT_DOUBLE_EQ(d.drives.rateLimit[i] * d.drives.gearRatio[i], 880);  // one motor speed, 8400 rpm
  }
}

}  // namespace
}  // namespace haptiv
