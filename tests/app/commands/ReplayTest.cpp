#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "tests/app/commands/HaptivProgram.h"
#include "tests/app/commands/TestFolder.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::json;

/// The log of a hand that pushes into a wall for two seconds.
class Replay : public ::testing::Test {
 protected:
  const TestFolder folder;
  const std::string scene = folder.write("wall.iv", wallScene());
  const std::string log = folder / "push.h5";

  void SetUp() override {
    const std::string hand = folder.write("push.csv", pushingHand());
    const Ended ended = runHaptiv({"run", scene, "--hand", hand, "--fast", "--log", log});
    ASSERT_EQ(ended.code, 0) << ended.err;
  }

  /// Of the same hand in another scene.
  std::string logOf(const std::string& name, const std::string& text) const {
    const std::string other = folder / (name + ".h5");
    const Ended ended =
        runHaptiv({"run", folder.write(name, text), "--hand", folder / "push.csv", "--fast", "--log", other});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return other;
  }
};

}  // namespace

TEST_F(Replay, InfoTellsWhatTheLogHolds) {
  const Ended ended = runHaptiv({"info", log, "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json info = ended.json();
  EXPECT_EQ(info["complete"], true);
  EXPECT_EQ(info["ticks"], 2000);
  EXPECT_EQ(info["duration_s"], 2.0);
  EXPECT_EQ(info["rate_Hz"], 1000.0);
  EXPECT_EQ(info["scene"], scene);
  EXPECT_EQ(info["device"], "vishard10");
  EXPECT_THAT(runHaptiv({"--version"}).out, HasSubstr(info["software_version"].get<std::string>()));
  EXPECT_TRUE(info["start"].is_null()) << "--fast has no clock";
  EXPECT_EQ(info["dropped"], 0);
  EXPECT_TRUE(info["seed"].is_number_unsigned());
  EXPECT_TRUE(info["scheduling"].is_string());
  EXPECT_EQ(info["faults"], Json::array());
  const Ended forPeople = runHaptiv({"info", log});
  EXPECT_THAT(forPeople.out, HasSubstr("2 s\n"));
  EXPECT_THAT(forPeople.out, HasSubstr("1000 Hz\n"));
}

TEST_F(Replay, VerifiesBitForBit) {
  const Ended ended = runHaptiv({"replay", log, "--verify", "--json"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.json(), (Json{{"identical", true}, {"ticks", 2000}, {"first_difference", nullptr}}));
  EXPECT_THAT(runHaptiv({"replay", log, "--verify"}).out, HasSubstr("identical"));
}

TEST_F(Replay, ExportsEveryTick) {
  const std::string csv = folder / "ticks.csv";
  const Ended ended = runHaptiv({"replay", log, "--export", csv, "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.json()["export"], csv);
  const std::string table = readFile(csv);
  EXPECT_THAT(table, StartsWith("t_s,"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 2001);
}

TEST_F(Replay, AnExportThatCannotBeWrittenIsAFailure) {
  for (const std::string& path : {folder / "no/such/ticks.csv", folder.fullDevice()}) {
    const Ended ended = runHaptiv({"replay", log, "--export", path});
    EXPECT_EQ(ended.code, 3) << path;
    EXPECT_THAT(ended.err, HasSubstr(path));
  }
}

TEST_F(Replay, WithoutActionAndDisplaySaysWhatCanBeDone) {
  const Ended ended = runHaptiv({"replay", log});
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("--verify"));
  EXPECT_THAT(ended.err, HasSubstr("--export"));
  EXPECT_EQ(runHaptiv({"replay", log, "--json"}).code, 2);
}

TEST_F(Replay, ATruncatedLogIsRefusedOrToldToBeCutOff) {
  const std::string whole = readFile(log);
  for (const double part : {0.001, 0.1, 0.5, 0.9}) {
    const std::string cut = folder.write("cut.h5", whole.substr(0, static_cast<std::size_t>(part * whole.size())));
    const Ended ended = runHaptiv({"info", cut, "--json"});
    if (ended.code == 0) {
      EXPECT_EQ(ended.json()["complete"], false) << part;
    } else {
      EXPECT_EQ(ended.code, 3) << part;
      EXPECT_THAT(ended.err, HasSubstr("cut.h5")) << part;
      EXPECT_EQ(ended.out, "") << part;
    }
  }
}

TEST_F(Replay, WhatIsNoLogIsRefused) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"info", scene}, {"replay", scene, "--verify"}, {"info", folder / ""}}) {
    const Ended ended = runHaptiv(arguments);
    EXPECT_EQ(ended.code, 3);
    EXPECT_THAT(ended.err, HasSubstr(arguments[1]));
  }
}

TEST_F(Replay, ALogOfAKilledSessionIsCutOffAndStillVerifies) {
  const std::string killed = folder / "killed.h5";
  HaptivProgram program({"run", scene, "--seconds", "50", "--log", killed});
  // The log is flushed every half second: wait for a few flushes' bytes.
  std::error_code missing;
  while (!std::filesystem::exists(killed, missing)) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  std::this_thread::sleep_for(std::chrono::seconds(3));
  program.send(SIGKILL);
  EXPECT_EQ(program.wait().code, 128 + SIGKILL);

  const Json info = runHaptiv({"info", killed, "--json"}).json();
  EXPECT_EQ(info["complete"], false);
  EXPECT_GT(info["ticks"].get<int>(), 0);
  EXPECT_TRUE(info["start"].is_string());
  const Ended verified = runHaptiv({"replay", killed, "--verify", "--json"});
  EXPECT_EQ(verified.code, 0) << verified.out;
  EXPECT_THAT(verified.err, HasSubstr("cut off"));
  EXPECT_EQ(verified.json()["identical"], true);
  EXPECT_EQ(verified.json()["ticks"], info["ticks"]);
}

TEST_F(Replay, InASofterWallTheSameHandGoesDeeper) {
  const Ended ended = runHaptiv({"replay", log, "--set", "stop.stiffness=1800", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json report = ended.json();
  EXPECT_EQ(report["set"], Json::array({"stop.stiffness=1800"}));
  EXPECT_GT(report["changed"]["max_penetration_m"], report["logged"]["max_penetration_m"]);
  EXPECT_GT(report["logged"]["max_penetration_m"], 0.0);
  EXPECT_EQ(report["logged"]["final_desired_position_m"].size(), 3u);

  // The same value as before changes nothing, and the node is found by its DEF name too.
  const Json same = runHaptiv({"replay", log, "--set", "Stop.stiffness=2000", "--json"}).json();
  EXPECT_EQ(same["changed"], same["logged"]);
  EXPECT_EQ(same["logged"], report["logged"]);
}

TEST_F(Replay, RefusesToSetWhatThereIsNot) {
  for (const char* wrong : {"stop", "stop.stiffness", "=5", ".stiffness=5", "stop.=5", "nobody.stiffness=5",
                            "stop.colour=5", "stop.stiffness=hard", "stop.stiffness=1e300"}) {
    const Ended ended = runHaptiv({"replay", log, "--set", wrong});
    EXPECT_EQ(ended.code, 2) << wrong;
    EXPECT_THAT(ended.err, HasSubstr("--set")) << wrong;
    EXPECT_EQ(ended.out, "") << wrong;
  }
  const Ended negative = runHaptiv({"replay", log, "--set", "stop.stiffness=-5"});
  EXPECT_EQ(negative.code, 1) << negative.err;
}

TEST_F(Replay, RefusesToSetWhatStaysAsLogged) {
  const std::string named = logOf("named.iv", R"(#Inventor V2.1 ascii
DEF Arm HapticDevice { }
DEF Ball HapticTool { home 0.3 0 0 }
)");
  for (const char* asLogged : {"Arm.scale=2", "Ball.home=0 0 1"}) {
    const Ended ended = runHaptiv({"replay", named, "--set", asLogged});
    EXPECT_EQ(ended.code, 2) << asLogged;
    EXPECT_THAT(ended.err, HasSubstr("are those of the log")) << asLogged;
  }
}

TEST_F(Replay, SetsWhatPrototypesMake) {
  const std::string made = logOf("made.wrl", R"(#VRML V2.0 utf8
PROTO Block [ field SFVec3f size 1 1 1 field SFFloat k 2000 field SFString name "" ] {
  Group { children [ HapticSurface { stiffness IS k label IS name } Shape { geometry Box { size IS size } } ] }
}
HapticTool { home 0.3 0 0 }
Transform { translation 0.3 0.2 0 children [ Block { size 0.4 0.1 0.4 name "stop" } ] }
Transform { translation 0.3 -0.2 0 children [ Block { size 0.4 0.1 0.4 k 1000 name "back" } ] }
)");
  const Json softer = runHaptiv({"replay", made, "--set", "stop.stiffness=1800", "--json"}).json();
  EXPECT_GT(softer["changed"]["max_penetration_m"], softer["logged"]["max_penetration_m"]);
  EXPECT_GT(softer["logged"]["max_penetration_m"], 0.0);
  const Json other = runHaptiv({"replay", made, "--set", "back.stiffness=1800", "--json"}).json();
  EXPECT_EQ(other["changed"], other["logged"]) << "all but what is set stays as it was";
}

/// They are read from the log: its reader may be anywhere.
TEST_F(Replay, SetsWhatTheSceneIncludes) {
  folder.write("stop.iv",
               "#Inventor V2.1 ascii\nHapticSurface { label \"stop\" }\n"
               "Translation { translation 0.3 0.2 0 }\nCube { width 0.4 height 0.1 depth 0.4 }\n");
  const std::string includes =
      logOf("includes.iv", "#Inventor V2.1 ascii\nHapticTool { home 0.3 0 0 }\nFile { name \"stop.iv\" }\n");
  const Json softer = runHaptiv({"replay", includes, "--set", "stop.stiffness=1800", "--json"}).json();
  EXPECT_GT(softer["changed"]["max_penetration_m"], softer["logged"]["max_penetration_m"]);
  EXPECT_GT(softer["logged"]["max_penetration_m"], 0.0);
}

/// Coin would read beyond its memory.
TEST_F(Replay, JudgesWhatIsSetAsAFileIsJudged) {
  const std::string faces = logOf("faces.iv", R"(#Inventor V2.1 ascii
HapticTool { home 0.3 0 0 }
HapticSurface { }
DEF Corners Coordinate3 { point [ 0 0.1 0, 1 0.1 0, 1 0.1 1 ] }
DEF Face IndexedFaceSet { coordIndex [ 0 1 2 -1 ] }
)");
  for (const char* wrong : {"Face.coordIndex=[ 0 1 100000000 -1 ]", "Corners.point=[ 0 0 0 ]"}) {
    const Ended ended = runHaptiv({"replay", faces, "--set", wrong});
    EXPECT_EQ(ended.code, 1) << wrong;
    EXPECT_THAT(ended.err, HasSubstr(":5: error: IndexedFaceSet \"Face\": reaches for coordinate")) << wrong;
  }
}

}  // namespace haptiv
