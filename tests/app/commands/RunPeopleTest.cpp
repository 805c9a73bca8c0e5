// Sessions that a person leads; no device is plugged into the machines that run this.
#include <gmock/gmock.h>

#include "tests/app/commands/HaptivProgram.h"
#include "tests/app/commands/TestFolder.h"

namespace haptiv {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string kScene = HAPTIV_SOURCE_DIR "/scenes/falcon-wall.iv";
const std::string kHand = HAPTIV_SOURCE_DIR "/tests/data/hands/push-falcon-wall.csv";

TEST(RunPeople, TheSimulatedFalconFeelsItsWall) {
  const Ended ended = runHaptiv({"run", kScene, "--hand", kHand, "--seconds", "1.9", "--fast", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto report = ended.json();
  EXPECT_EQ(report["control"], "impedance");
  EXPECT_EQ(report["faults"], nlohmann::json::array());
  // The hand of 200 N/m wants to be 20 mm beyond the touch, the wall has 600 N/m: 3 N, and the legs' dry friction.
  EXPECT_NEAR(report["final_contact_force_N"].get<double>(), 3, 0.3);
  EXPECT_NEAR(report["final_penetration_m"].get<double>(), 0.005, 0.0005);
}

TEST(RunPeople, NoOneCanKeepUpWithAFastRun) {
  for (const std::vector<std::string>& person :
       {std::vector<std::string>{"--hand", "spacemouse"}, {"--hand", "spacemouse:position"}, {"--device", "falcon"}}) {
    std::vector<std::string> arguments = {"run", kScene, "--fast"};
    arguments.insert(arguments.end(), person.begin(), person.end());
    const Ended ended = runHaptiv(arguments);
    EXPECT_EQ(ended.code, 2) << person.back();
    EXPECT_THAT(ended.err, HasSubstr("--fast"));
  }
}

TEST(RunPeople, AFalconHasAHandOfItsOwn) {
  const Ended ended = runHaptiv({"run", kScene, "--device", "falcon", "--hand", kHand});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("leave it out"));
}

TEST(RunPeople, SaysThatNothingIsPluggedIn) {
  const Ended mouse = runHaptiv({"run", kScene, "--hand", "spacemouse", "--seconds", "1"});
  EXPECT_EQ(mouse.code, 3);
  EXPECT_THAT(mouse.err, AllOf(HasSubstr("SpaceMouse"), HasSubstr("plug one in")));
  const Ended falcon = runHaptiv({"run", kScene, "--device", "falcon:7", "--seconds", "1"});
  EXPECT_EQ(falcon.code, 3);
  EXPECT_THAT(falcon.err, HasSubstr("Novint Falcon"));
}

TEST(RunPeople, AFalconIsNotTheArmOfAnotherScene) {
  const Ended ended = runHaptiv({"run", HAPTIV_SOURCE_DIR "/scenes/wall.iv", "--device", "falcon"});
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("vishard10"));
}

TEST(RunPeople, TheFalconsLegsHaveKinematicsLikeAnyArm) {
  const Ended ended = runHaptiv({"kinematics", "--description", "falcon", "--q", "0.6,0.6,0.6", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_NEAR(ended.json()["position_m"][0].get<double>(), 0, 1e-9);
  EXPECT_GT(ended.json()["position_m"][2].get<double>(), 0.1);
  const Ended check = runHaptiv({"device", "check", "falcon"});
  EXPECT_EQ(check.code, 2);
  EXPECT_THAT(check.err, HasSubstr("parallel"));
}

}  // namespace
}  // namespace haptiv
