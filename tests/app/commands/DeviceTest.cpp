#include <gmock/gmock.h>

#include <QImage>
#include <filesystem>
#include <map>

#include "tests/app/commands/HaptivProgram.h"
#include "tests/app/commands/TestFolder.h"

namespace haptiv {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using Json = nlohmann::json;

}  // namespace

TEST(Device, ListNamesOnlyWhatIsThereAndSaysWhatToDo) {
  const Ended table = runHaptiv({"device", "list"});
  EXPECT_EQ(table.code, 0);
  for (const char* there : {"sim", "vishard10", "anthropomorphic7", "10 joints", "7 joints",
                            "no interface board, Falcon or SpaceMouse is plugged in. Plug one in"})
    EXPECT_THAT(table.out, HasSubstr(there));
  const Json list = runHaptiv({"device", "list", "--json"}).json();
  EXPECT_EQ(list["devices"], Json::array({"sim"}));
  for (const char* kind : {"usb", "falcon", "spacemouse"}) EXPECT_EQ(list[kind], Json::array()) << kind;
  EXPECT_THAT(list["descriptions"], Contains(Json({{"name", "anthropomorphic7"}, {"joints", 7}})));
}

TEST(Device, AsksForOneOfItsCommands) {
  const Ended none = runHaptiv({"device"});
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("list, check, monitor, calibrate, home"));
  const Ended other = runHaptiv({"device", "paint"});
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("paint"));
  EXPECT_EQ(runHaptiv({"device", "check", "--strategy", "best"}).code, 2);
}

TEST(Device, NamesThatSayNotWhichOneAreWrongUsage) {
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"monitor", "--device", "usb:"},
                                                {"home", "--device", "usb:"},
                                                {"monitor", "--device", "falcon"},
                                                {"calibrate", "--device", "falcon"},
                                                {"calibrate", "falcon"}}) {
    std::vector<std::string> arguments = wrong;
    arguments.insert(arguments.begin(), "device");
    const Ended ended = runHaptiv(arguments);
    EXPECT_EQ(ended.code, 2) << wrong[0] << ended.err;
  }
}

TEST(Device, CheckNamesADescriptionThatIsNotThereOrBad) {
  const TestFolder folder;
  EXPECT_EQ(runHaptiv({"device", "check", folder / "missing.toml"}).code, 3);
  const std::string bad = folder.write("bad.toml", "schema = 1\n[links]\nlift = -1\n");
  const Ended ended = runHaptiv({"device", "check", bad});
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr(bad + ":3:8: "));
}

TEST(Device, CheckFindsTheSingularityInTheShoulderAndDrawsTheMap) {
  const TestFolder folder;
  const std::string map = folder / "map.png";
  const Ended ended = runHaptiv({"device", "check", "anthropomorphic7", "--json", "--map", map});
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.err, HasSubstr("interior singularity at the shoulder"));
  const Json report = ended.json();
  EXPECT_FALSE(report["holds"].get<bool>());
  std::map<std::string, bool> holds;
  for (const Json& row : report["rows"]) {
    EXPECT_EQ(row["joint_angles_rad"].size(), 7u);
    holds[row["property"]] = row["holds"];
  }
  EXPECT_FALSE(holds["sigma_min_trans_m"]);
  EXPECT_TRUE(holds["force_N"]);
  EXPECT_EQ(QImage(QString::fromStdString(map)).size(), QSize(1280, 720));
}

TEST(Device, ASceneMayNameAnyArmAndAFileBesideIt) {
  const TestFolder folder;
  std::filesystem::copy_file(HAPTIV_SOURCE_DIR "/device/descriptions/anthropomorphic7.toml", folder / "my-arm.toml");
  const std::string hand = folder.write("push.csv", pushingHand());
  for (const std::string description : {"anthropomorphic7", "my-arm.toml"}) {
    const std::string scene = folder.write(
        "wall.iv", wallScene("", "HapticDevice { description \"" + description + "\" position -0.1 0 0 }"));
    const Ended ended = runHaptiv({"run", scene, "--hand", hand, "--fast", "--json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NEAR(ended.json()["final_contact_force_N"], 20, 0.4);  // as VISHARD10 does: RunTest
    EXPECT_NEAR(ended.json()["final_position_m"][1], 0.15, 0.001);
  }
}

TEST(Device, KinematicsAreThoseOfTheDescription) {
  const Ended ended = runHaptiv({"kinematics", "--description", "anthropomorphic7", "--q", "0,0,0,0,0,0,0", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.json()["position_m"], Json::array({1.0, 0.0, 0.0}));
  EXPECT_EQ(ended.json()["jacobian"][0].size(), 7u);
  EXPECT_EQ(runHaptiv({"kinematics", "--description", "anthropomorphic7", "--q", "0,0,0"}).code, 2);
}

}  // namespace haptiv
