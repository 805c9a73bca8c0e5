/// The Falcon's driver over real libusb and a virtual bus, a virtual Falcon behind it.
#include "device/usb/falcon/FalconDevice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "device/kinematics/ArmKinematics.h"
#include "haptics/servo/FastLoop.h"
#include "tests/device/usb/falcon/BenchedFalcon.h"

namespace haptiv::falcon::test {
namespace {

using testing::HasSubstr;

constexpr double kTick = 1e-3;

class FalconOverUsb : public testing::Test {
 protected:
  DeviceReading push(double torque, int ticks) {
    DeviceCommand command;
    command.enabled = true;
    command.mode = DriveMode::torque;
    command.jointTorques.head<3>().setConstant(torque);
    for (int i = 0; i < ticks; ++i) bench_.write(command);
    return bench_.read();
  }
  std::string troubleOfStart() {
    try {
      bench_.start(kTick);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  }
  bool isStill() { return bench_.falcon().lastOrder().motors == Order{}.motors; }

  DeviceDescription description_ = loadDeviceDescription("falcon");
  BenchedFalcon bench_{description_};
};

TEST_F(FalconOverUsb, IsSetUpAndTellsWhereItsLegsAre) {
  bench_.start(kTick);
  EXPECT_EQ(bench_.falcon().stage(), VirtualFalcon::Stage::running);
  EXPECT_EQ(bench_.falcon().firmware(), Bytes(4096, 0x7f));
  const DeviceReading reading = push(0, 5);
  EXPECT_TRUE(reading.connected);
  EXPECT_EQ(reading.inputs, kInputDeadMan);
  EXPECT_EQ(reading.sensorCounts, (std::array<std::int16_t, 6>{}));
  const JointVector error = description_.jointAngles(reading) - bench_.falcon().arm().angles();
  EXPECT_LT(error.cwiseAbs().maxCoeff(), 1 / description_.drives.countsPerRadian()[0]);
}

TEST_F(FalconOverUsb, TorquesReachTheMotorsWithinTheTickAfterNext) {
  bench_.start(kTick);
  push(0, 5);
  push(0.05, 2);
  const auto value = static_cast<std::int16_t>(std::lround(0.05 * description_.falcon.torqueCounts));
  EXPECT_EQ(bench_.falcon().lastOrder().motors, (std::array{value, value, value}));
  EXPECT_EQ(bench_.falcon().lastOrder().leds, kGreen);
  EXPECT_TRUE(bench_.falcon().lastOrder().homing);
}

TEST_F(FalconOverUsb, SpeaksOncePerTick) {
  bench_.start(kTick);
  push(0, 10);
  const std::uint64_t before = bench_.falcon().orders();
  const Figures figures = bench_.device().figures();
  push(0, 500);
  EXPECT_NEAR(static_cast<double>(bench_.falcon().orders() - before), 500, 2);
  EXPECT_EQ(bench_.device().figures().damaged, figures.damaged);
  EXPECT_LE(bench_.device().figures().unasked - figures.unasked, 1u);
}

TEST_F(FalconOverUsb, LettingGoOfTheDeadManTakesTheTorqueAway) {
  bench_.start(kTick);
  push(0.05, 10);
  EXPECT_FALSE(isStill());
  bench_.buttons = 0;
  EXPECT_EQ(push(0.05, 3).inputs, 0);
  EXPECT_TRUE(isStill());
}

TEST_F(FalconOverUsb, AFewLostOrDamagedAnswersAreBorne) {
  bench_.start(kTick);
  push(0.02, 10);
  bench_.falcon().faults().answersLost = 1;
  EXPECT_TRUE(push(0.02, 8).connected);
  bench_.falcon().faults().answersDamaged = 1;
  EXPECT_TRUE(push(0.02, 8).connected);
  EXPECT_EQ(bench_.device().figures().damaged, 1u);
  EXPECT_FALSE(isStill());
}

TEST_F(FalconOverUsb, FaultsOfTheLineAreBorne) {
  using haptiv::test::LineFaults;
  bench_.start(kTick);
  push(0.005, 10);
  for (int LineFaults::*const fault :
       {&LineFaults::lose, &LineFaults::corrupt, &LineFaults::shorten, &LineFaults::lengthen, &LineFaults::damage,
        &LineFaults::babble, &LineFaults::stallIn, &LineFaults::stallOut, &LineFaults::loseOut, &LineFaults::repeatOut,
        &LineFaults::corruptOut}) {
    bench_.port().faults.*fault = 1;
    push(0.005, 12);
    EXPECT_EQ(bench_.port().faults.*fault, 0) << "it befell";
    EXPECT_TRUE(push(0.005, 12).connected);
    EXPECT_FALSE(isStill()) << "it goes on";
  }
  EXPECT_LE(bench_.falcon().largestMotor(), 4096);
}

TEST_F(FalconOverUsb, ASilentFalconIsNotThereUntilItSpeaksAgain) {
  bench_.start(kTick);
  push(0.02, 10);
  bench_.falcon().faults().answersLost = 1000;
  EXPECT_FALSE(push(0.02, 15).connected);
  push(0.02, 6);
  EXPECT_TRUE(isStill()) << "what it can still hear asks for nothing";
  bench_.falcon().faults().answersLost = 0;
  EXPECT_TRUE(push(0.02, 12).connected);
}

TEST_F(FalconOverUsb, IsHomedByTheOperatorWhoIsToldTo) {
  std::string told;
  bench_.tell = [&](const std::string& what) { told = what; };
  bench_.beforePlugging = [](VirtualFalcon& falcon) {
    falcon.faults().homesByItself = false;
    falcon.faults().operatorHomes = true;
  };
  bench_.start(kTick);
  EXPECT_THAT(told, HasSubstr("pull the grip all the way out"));
  const DeviceReading reading = push(0, 200);
  EXPECT_TRUE(reading.connected);
  const JointVector error = description_.jointAngles(reading) - bench_.falcon().arm().angles();
  EXPECT_LT(error.cwiseAbs().maxCoeff(), 0.01) << "of a grip that falls back, a tick later";
}

TEST_F(FalconOverUsb, NoTorqueIsAskedForBeforeItIsHomed) {
  bench_.beforePlugging = [](VirtualFalcon& falcon) { falcon.faults().homesByItself = false; };
  bench_.homingTime = std::chrono::seconds(0);
  EXPECT_THAT(troubleOfStart(), HasSubstr("has not been homed"));
  EXPECT_EQ(bench_.falcon().largestMotor(), 0);
}

TEST_F(FalconOverUsb, ALegThatLosesItsZeroTakesItAllAwayForGood) {
  bench_.start(kTick);
  push(0.02, 10);
  bench_.falcon().faults().unhomed = 2;
  EXPECT_FALSE(push(0.02, 3).connected);
  EXPECT_TRUE(isStill());
  bench_.falcon().faults().unhomed = 0;
  EXPECT_FALSE(push(0.02, 50).connected) << "its counts are others now";
  EXPECT_TRUE(isStill());
}

TEST_F(FalconOverUsb, UnpluggedInFlightItIsGoneAndPluggedInAgainItIsSetUpAnew) {
  bench_.start(kTick);
  push(0.02, 10);
  bench_.unplug();
  EXPECT_FALSE(push(0.02, 1).connected);
  EXPECT_FALSE(push(0.02, 20).connected);
  EXPECT_EQ(bench_.device().figures().losses, 1u);
  bench_.plug();
  bench_.buttons = 0;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  bool back = false;
  bench_.whileTheBusRuns([&] {
    while (!back && std::chrono::steady_clock::now() < end) {
      back = bench_.device().read().connected;
      bench_.device().write({});
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  EXPECT_TRUE(back);
  EXPECT_EQ(bench_.falcon().firmware(), Bytes(4096, 0x7f));
  EXPECT_EQ(bench_.falcon().largestMotor(), 0);
}

TEST_F(FalconOverUsb, PluggedInAgainWithoutItsFirmwareItStaysAway) {
  bench_.start(kTick);
  push(0.02, 10);
  bench_.unplug();
  push(0.02, 2);
  bench_.loseFirmwareFile();
  bench_.plug();
  bench_.whileTheBusRuns([] { std::this_thread::sleep_for(std::chrono::seconds(1)); });
  EXPECT_FALSE(push(0.02, 5).connected);
  EXPECT_EQ(bench_.falcon().orders(), 0u);
}

TEST_F(FalconOverUsb, AServoThatStopsLeavesNoTorqueStanding) {
  bench_.start(kTick);
  push(0.05, 10);
  EXPECT_FALSE(isStill());
  std::this_thread::sleep_for(std::chrono::milliseconds(20));  // twice the watchdog's time
  bench_.bus().tick(3 * Client::kPatience);
  EXPECT_TRUE(isStill());
}

TEST_F(FalconOverUsb, StoppingLeavesNoTorqueStanding) {
  bench_.start(kTick);
  push(0.05, 10);
  bench_.stop();
  EXPECT_TRUE(isStill());
}

TEST_F(FalconOverUsb, SaysWhatIsWrongWithTheSetUp) {
  EXPECT_THROW(FalconDevice(loadDeviceDescription("vishard10")), std::runtime_error);
  FalconDevice none(description_);
  try {
    none.start(kTick);
    FAIL() << "there is no Falcon";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("Novint Falcon"));
  }
  EXPECT_THROW(none.start(0.5e-3), std::runtime_error) << "2 kHz";
  bench_.beforePlugging = [](VirtualFalcon& falcon) { falcon.faults().firmwareDead = true; };
  EXPECT_THAT(troubleOfStart(), HasSubstr("is the file the Falcon's?"));
}

TEST_F(FalconOverUsb, AHandRestsInAWallAsDeepAsItPushes) {
  HapticScene scene;
  scene.device.description = "falcon";
  const Vector3 home = ArmKinematics(description_).forward(description_.homeAngles).position;
  scene.tool = {0.3, 1, 0.01, home};
  Wall wall;  // its face towards +z, 2 cm behind the ball's centre
  wall.shape.centre = home - Vector3(0, 0, 0.06);
  wall.shape.axes = Vector3(0.06, 0.06, 0.04).asDiagonal();
  wall.surface.stiffness = 600;
  wall.surface.damping = 4;
  scene.walls.push_back(wall);
  computeBounds(scene);
  constexpr double kForce = 3, kTouch = 0.01;  // [N], [m] below home
  const double depth = kForce / 600;
  HandTarget hand{true, home - Vector3(0, 0, kTouch + depth + kForce / description_.hand.stiffness)};
  bench_.beforePlugging = [&](VirtualFalcon& falcon) { falcon.setHand(hand); };

  double force = 0, least = 1e9, most = 0;
  std::uint64_t ticks = 0;
  runFast(bench_, description_, 1000, scene, 2000, [&](const TickRecord& record) {
    EXPECT_EQ(record.faults, kNoFault) << record.tick;
    if (++ticks <= 1500) return true;
    force = record.environmentForce.z();
    least = std::min(least, force);
    most = std::max(most, force);
    return true;
  });
  EXPECT_NEAR(least, kForce, 0.4) << "the legs' dry friction carries a part";
  EXPECT_NEAR(most, kForce, 0.4);
  EXPECT_LT(bench_.falcon().largestMotor(), 4096);
}

}  // namespace
}  // namespace haptiv::falcon::test
