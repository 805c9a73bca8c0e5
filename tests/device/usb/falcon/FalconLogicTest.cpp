#include "device/usb/falcon/FalconLogic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/LU>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "device/kinematics/ArmKinematics.h"
#include "device/usb/falcon/FalconFirmware.h"
#include "tests/support/Random.h"

namespace haptiv::falcon {
namespace {

using testing::HasSubstr;

const std::uint8_t kHeld = Logic::kDeadManButton;

DeviceCommand pushing(double torque) {
  DeviceCommand command;
  command.enabled = true;
  command.mode = DriveMode::torque;
  command.jointTorques.head<3>().setConstant(torque);
  return command;
}

class FalconLogic : public testing::Test {
 protected:
  Order order(const DeviceCommand& command, std::uint8_t buttons = kHeld, Homing homing = Homing::homed) const {
    return logic_.order(command, State{{}, kAllHomed, buttons}, homing);
  }

  DeviceDescription description_ = loadDeviceDescription("falcon");
  Logic logic_{description_};
};

TEST_F(FalconLogic, HomesOnceAllLegsHaveAndIsLostOnceOneHasNot) {
  Homing homing = Homing::searching;
  for (const std::uint8_t legs : {0, 1, 3, 5, 6}) EXPECT_EQ(homing = next(homing, legs), Homing::searching);
  EXPECT_EQ(homing = next(homing, kAllHomed), Homing::homed);
  EXPECT_EQ(next(homing, kAllHomed), Homing::homed);
  homing = next(homing, 6);
  EXPECT_EQ(homing, Homing::lost);
  EXPECT_EQ(next(homing, kAllHomed), Homing::lost) << "the counts are others now";
}

TEST_F(FalconLogic, AHomedCounterOfZeroIsTheHomedAngle) {
  const JointVector q = description_.jointAngles(logic_.reading({{0, 10, -10}, kAllHomed, 0}, Homing::homed));
  const double count = 1 / description_.drives.countsPerRadian()[0];
  EXPECT_NEAR(q[0], description_.falcon.homedAngle, count / 2);
  EXPECT_NEAR(q[1] - q[0], 10 * count, 1e-12);
  EXPECT_NEAR(q[2] - q[0], -10 * count, 1e-12);
  EXPECT_EQ(q.tail<7>(), (Eigen::Matrix<double, 7, 1>::Zero()));
}

TEST_F(FalconLogic, IsNotThereBeforeItIsHomed) {
  for (const Homing homing : {Homing::searching, Homing::lost}) {
    const DeviceReading reading = logic_.reading({{1, 2, 3}, 0, 0xF}, homing);
    EXPECT_FALSE(reading.connected);
    EXPECT_EQ(reading.inputs, 0) << "nobody's hand starts it";
  }
  EXPECT_TRUE(logic_.reading({{1, 2, 3}, kAllHomed, 0}, Homing::homed).connected);
}

TEST_F(FalconLogic, TheRoundButtonIsTheDeadManAndTheOneBeforeItTheReset) {
  const auto inputs = [&](std::uint8_t buttons) {
    return logic_.reading({{}, kAllHomed, buttons}, Homing::homed).inputs;
  };
  EXPECT_EQ(inputs(0), 0);
  EXPECT_EQ(inputs(4), kInputDeadMan);
  EXPECT_EQ(inputs(2), kInputReset);
  EXPECT_EQ(inputs(1 | 8), 0);
}

TEST_F(FalconLogic, TurnsTorquesIntoMotorValuesWithinTheLimits) {
  EXPECT_EQ(order(pushing(0.1)).motors[0], std::lround(0.1 * description_.falcon.torqueCounts));
  EXPECT_EQ(order(pushing(-0.1)).motors[2], -std::lround(0.1 * description_.falcon.torqueCounts));
  for (const double torque : {1., 1e9, 1e300}) {
    EXPECT_EQ(order(pushing(torque)).motors[1], 4096);
    EXPECT_EQ(order(pushing(-torque)).motors[1], -4096);
  }
}

TEST_F(FalconLogic, NoDescriptionLetsAMotorValueGoBeyondItsBits) {
  description_.falcon.torqueCounts = 1e9;
  description_.falcon.mostTorqueCounts = 1e9;
  EXPECT_EQ(Logic(description_).order(pushing(1), {{}, kAllHomed, kHeld}, Homing::homed).motors[0], 32767);
}

TEST_F(FalconLogic, PushesOnlyWhereAllAllowsIt) {
  const Order none{};
  const auto isStill = [&](const Order& order) { return order.motors == none.motors && order.homing; };
  EXPECT_FALSE(isStill(order(pushing(0.1))));
  EXPECT_TRUE(isStill(order(pushing(0.1), 0))) << "the dead-man is released";
  for (const Homing homing : {Homing::searching, Homing::lost})
    EXPECT_TRUE(isStill(order(pushing(0.1), kHeld, homing)));
  DeviceCommand command = pushing(0.1);
  command.enabled = false;
  EXPECT_TRUE(isStill(order(command)));
  command = pushing(0.1);
  command.mode = DriveMode::rate;
  command.jointRates.setConstant(1);
  EXPECT_TRUE(isStill(order(command))) << "it has no velocity loops";
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    command = pushing(0.1);
    command.jointTorques[1] = bad;
    EXPECT_TRUE(isStill(order(command)));
  }
}

TEST_F(FalconLogic, LightsTellTheOperatorHowItStands) {
  EXPECT_EQ(order(pushing(0), 0, Homing::searching).leds, kRed);
  EXPECT_EQ(order(pushing(0), 0, Homing::lost).leds, kRed);
  EXPECT_EQ(order(DeviceCommand{}).leds, kBlue);
  EXPECT_EQ(order(pushing(0)).leds, kGreen);
}

TEST_F(FalconLogic, AForceThatIsWithinAllLimitsComesOutAsAsked) {
  haptiv::test::Random random(1);
  const ArmKinematics arm(description_);
  for (int i = 0; i < 200; ++i) {
    const JointVector q = arm.inverse(
        {random.between(-0.02, 0.02), random.between(-0.02, 0.02), random.between(0.1, 0.13)}, description_.homeAngles);
    const auto force = random.vector<Vector3>(-1.5, 1.5);
    DeviceCommand command = pushing(0);
    const Eigen::Matrix3d J = arm.evaluate(q).J_BT.topLeftCorner<3, 3>();
    command.jointTorques.head<3>() = J.transpose() * force;
    const Order given = order(command);
    Vector3 torques;
    for (int leg = 0; leg < 3; ++leg)
      torques[leg] = given.motors[static_cast<std::size_t>(leg)] / description_.falcon.torqueCounts;
    // Half a motor value a leg, and what the inverse of J makes of it.
    const double rounding = J.inverse().norm() * 0.5 * std::sqrt(3) / description_.falcon.torqueCounts;
    EXPECT_LT((J.transpose().inverse() * torques - force).norm(), rounding) << i;
  }
}

/// A file of the tests' own, removed in the end.
class FirmwareFile {
 public:
  explicit FirmwareFile(const std::string& bytes)
      : path_(std::filesystem::temp_directory_path() / ("haptiv-firmware-" + std::to_string(::getpid()))) {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~FirmwareFile() { std::filesystem::remove(path_); }
  std::string path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string refusal(const std::string& path) {
  try {
    readFirmware(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(FalconFirmware, IsTakenByteForByte) {
  std::string bytes(5000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i);
  const auto read = readFirmware(FirmwareFile(bytes).path());
  EXPECT_EQ(std::string(read.begin(), read.end()), bytes);
}

TEST(FalconFirmware, RefusesWhatIsNoneAndSaysWhatToDo) {
  EXPECT_THAT(refusal("/nowhere/falcon.bin"), AllOf(HasSubstr("/nowhere/falcon.bin"), HasSubstr("--firmware")));
  EXPECT_THAT(refusal("/dev/zero"), HasSubstr("no such firmware file"));
  EXPECT_THAT(refusal("/"), HasSubstr("no such firmware file"));
  EXPECT_THAT(refusal(FirmwareFile("").path()), HasSubstr("1 kB to 256 kB"));
  EXPECT_THAT(refusal(FirmwareFile(std::string(300'000, '\1')).path()), HasSubstr("1 kB to 256 kB"));
  EXPECT_THAT(refusal(FirmwareFile(std::string(2000, 'a')).path()), HasSubstr("is text"));
}

}  // namespace
}  // namespace haptiv::falcon
