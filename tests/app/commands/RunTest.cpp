#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QImage>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <set>
#include <thread>

#include "tests/app/commands/HaptivProgram.h"
#include "tests/app/commands/TestFolder.h"

namespace haptiv {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using Json = nlohmann::json;

/// A wall and a hand that pushes 20 N into it.
class Run : public ::testing::Test {
 protected:
  const TestFolder folder;
  const std::string scene = folder.write("wall.iv", wallScene());
  const std::string hand = folder.write("push.csv", pushingHand());

  Ended run(std::vector<std::string> more) const {
    more.insert(more.begin(), {"run", scene, "--hand", hand});
    return runHaptiv(more);
  }
};

}  // namespace

TEST_F(Run, PushingTwentyNewtonsRestsTenMillimetresInTheWall) {
  const Ended ended = run({"--seconds", "5", "--fast", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  const Json report = ended.json();
  ASSERT_TRUE(report.is_object()) << ended.out;
  // 2 %, as issue 2 asks: the sensor resolves 0.02 N and has as much noise, the encoders resolve 0.01 mm.
  EXPECT_NEAR(report["final_contact_force_N"], 20, 0.4);
  EXPECT_NEAR(report["final_penetration_m"], 0.010, 0.0002);
  EXPECT_NEAR(report["final_position_m"][0], 0.3, 0.001);
  EXPECT_NEAR(report["final_position_m"][1], 0.15, 0.001);
  EXPECT_NEAR(report["final_position_m"][2], 0, 0.001);
  EXPECT_GE(report["max_force_N"], report["final_contact_force_N"]);
  EXPECT_GE(report["max_penetration_m"], report["final_penetration_m"]);
  EXPECT_GE(report["contacts"].get<int>(), 1);
  EXPECT_EQ(report["ticks"], 5000);
  EXPECT_EQ(report["missed_ticks"], 0);
  EXPECT_EQ(report["faults"], Json::array());
  EXPECT_EQ(report["seconds"], 5.0);
  EXPECT_EQ(report["rate_Hz"], 1000.0);
  EXPECT_FALSE(report.contains("log"));
  EXPECT_FALSE(report.contains("picture"));
}

TEST_F(Run, LastsAsLongAsTheHandFileAndASecondMore) {
  EXPECT_EQ(run({"--fast", "--json"}).json()["ticks"], 2000);
  EXPECT_EQ(runHaptiv({"run", scene, "--fast", "--json", "--rate", "500"}).json()["ticks"], 2500);
}

TEST_F(Run, TouchesNothingWhereTheHandIsAtRest) {
  const Json report = runHaptiv({"run", scene, "--hand", "rest", "--fast", "--json"}).json();
  EXPECT_EQ(report["contacts"], 0);
  EXPECT_EQ(report["max_force_N"], 0.0);
  EXPECT_NEAR(report["final_position_m"][1], 0, 0.001);
}

TEST_F(Run, TableForPeopleHasUnits) {
  const Ended ended = run({"--fast"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  for (const char* part : {"max force", " N\n", "max penetration", " m\n", "faults", "none"})
    EXPECT_THAT(ended.out, HasSubstr(part));
}

TEST_F(Run, TheStrategyIsToldLoggedAndResimulated) {
  const std::string log = folder / "dir.h5";
  const Ended ended = run({"--fast", "--strategy", "dir", "--solution", "partitioned", "--log", log, "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json info = runHaptiv({"info", log, "--json"}).json();
  for (const Json& told : {ended.json(), info}) {
    EXPECT_EQ(told["strategy"], "dir");
    EXPECT_EQ(told["solution"], "partitioned");
  }
  EXPECT_EQ(info["resolution_changes"], Json::array());
  EXPECT_EQ(runHaptiv({"replay", log, "--verify"}).code, 0);
}

TEST_F(Run, EveryWayToDriveTheArmIsToldLoggedAndResimulated) {
  const std::string log = folder / "control.h5";
  for (const std::string control : {"admittance", "position-impedance", "impedance"}) {
    for (const std::string joints : {"pd", "computed-torque"}) {
      for (const std::string orientation : {"held", "free"}) {
        const Ended ended =
            runHaptiv({"run", scene, "--hand", "rest", "--fast", "--seconds", "0.5", "--control", control, "--joints",
                       joints, "--orientation", orientation, "--log", log, "--json"});
        ASSERT_EQ(ended.code, 0) << control << joints << orientation << ended.err;
        for (const Json& told : {ended.json(), runHaptiv({"info", log, "--json"}).json()}) {
          EXPECT_EQ(told["control"], control);
          EXPECT_EQ(told["joints"], joints);
          EXPECT_EQ(told["orientation"], orientation);
          EXPECT_EQ(told["passivity"], false);
        }
        EXPECT_EQ(runHaptiv({"replay", log, "--verify"}).code, 0) << control << joints << orientation;
      }
    }
  }
}

TEST_F(Run, ComputedTorqueNeedsAnArmWhoseLinksAreTold) {
  const std::string arm = folder.write("arm.toml", "schema = 1\nname = \"bare\"\n");
  const std::string bare = folder.write("bare.iv",
                                        "#Inventor V2.1 ascii\nHapticDevice { description \"arm.toml\" }\n"
                                        "HapticTool { home 0.35 0 0 }\n");
  const Ended ended = runHaptiv({"run", bare, "--fast", "--seconds", "0.1", "--joints", "computed-torque"});
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("[[bodies.link]]"));
}

TEST_F(Run, AnotherArmIsResolvedInFullOnly) {
  const std::string seven = folder.write(
      "seven.iv",
      "#Inventor V2.1 ascii\nHapticDevice { description \"anthropomorphic7\" }\nHapticTool { home 0.4 0 0 }\n");
  const Ended full = runHaptiv({"run", seven, "--fast", "--seconds", "0.1", "--strategy", "dir", "--json"});
  EXPECT_EQ(full.code, 0) << full.err;
  const Ended torque = runHaptiv({"run", seven, "--fast", "--seconds", "0.5", "--joints", "computed-torque", "--json"});
  EXPECT_EQ(torque.code, 0) << torque.err;
  const Ended partitioned = runHaptiv({"run", seven, "--fast", "--seconds", "0.1", "--solution", "partitioned"});
  EXPECT_EQ(partitioned.code, 3);
  EXPECT_THAT(partitioned.err, HasSubstr("no partitioned solution"));
}

TEST_F(Run, TwoFastRunsGiveTheSameData) {
  for (const std::string name : {"a", "b"}) {
    ASSERT_EQ(run({"--fast", "--log", folder / (name + ".h5")}).code, 0);
    ASSERT_EQ(runHaptiv({"replay", folder / (name + ".h5"), "--export", folder / (name + ".csv")}).code, 0);
  }
  const std::string first = readFile(folder / "a.csv");
  EXPECT_GT(std::count(first.begin(), first.end(), '\n'), 2000);
  EXPECT_EQ(first, readFile(folder / "b.csv"));
  EXPECT_EQ(runHaptiv({"info", folder / "a.h5", "--json"}).out, runHaptiv({"info", folder / "b.h5", "--json"}).out);
}

TEST_F(Run, LiveSessionTellsHowItWasScheduledAndVerifies) {
  const std::string log = folder / "live.h5";
  const Ended ended = run({"--seconds", "1", "--json", "--log", log});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json report = ended.json();
  EXPECT_NE(report["scheduling"].get<std::string>(), "");
  EXPECT_EQ(report["log"], log);
  EXPECT_GT(report["ticks"].get<int>(), 0);
  const Ended verified = runHaptiv({"replay", log, "--verify", "--json"});
  EXPECT_EQ(verified.code, 0) << verified.out << verified.err;
  EXPECT_EQ(verified.json()["identical"], true);
  EXPECT_EQ(verified.json()["ticks"], report["ticks"]);
}

TEST_F(Run, ControlCEndsALiveSessionWithItsSummaryAndACompleteLog) {
  const std::string log = folder / "live.h5";
  HaptivProgram program({"run", scene, "--seconds", "40", "--json", "--log", log});
  while (!std::filesystem::exists(log)) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  std::this_thread::sleep_for(std::chrono::milliseconds(700));  // so that there are ticks
  program.send(SIGINT);
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 0) << ended.err;
  ASSERT_TRUE(ended.json().is_object()) << ended.out;
  EXPECT_LT(ended.json()["seconds"].get<double>(), 40);
  const Json info = runHaptiv({"info", log, "--json"}).json();
  EXPECT_EQ(info["complete"], true);
  EXPECT_EQ(info["ticks"], ended.json()["ticks"]);
}

TEST_F(Run, DrawsAPictureWithoutADisplay) {
  const std::string path = folder / "end.png";
  const Ended ended = run({"--fast", "--picture", path, "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.json()["picture"], path);
  EXPECT_THAT(readFile(path).substr(0, 8), "\x89PNG\r\n\x1a\n");
  const QImage picture(QString::fromStdString(path));
  EXPECT_EQ(picture.width(), 1280);
  EXPECT_EQ(picture.height(), 720);
  std::set<QRgb> colours;
  for (int y = 0; y < picture.height(); y += 4)
    for (int x = 0; x < picture.width(); x += 4) colours.insert(picture.pixel(x, y));
  EXPECT_GT(colours.size(), 20u) << "nothing seems to be drawn";
}

TEST_F(Run, APictureThatCannotBeWrittenIsAFailureBeforeOrAfterTheSession) {
  for (const std::string& path : {folder / "no/such/folder/end.png", folder / "", folder.fullDevice()}) {
    const Ended ended = run({"--fast", "--picture", path});
    EXPECT_EQ(ended.code, 3) << path;
    EXPECT_THAT(ended.err, HasSubstr("cannot be written")) << path;
  }
}

TEST_F(Run, APictureIsWrittenIntoAPipeAndDoesNotReplaceIt) {
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  ASSERT_GT(fcntl(reader, F_SETPIPE_SZ, 1 << 20), 0);  // [bytes] more than the picture has
  EXPECT_EQ(run({"--fast", "--picture", pipe}).code, 0);
  std::string head(8, ' ');
  EXPECT_EQ(read(reader, head.data(), head.size()), 8);
  EXPECT_EQ(head, "\x89PNG\r\n\x1a\n");
  close(reader);
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST_F(Run, ALogThatCannotBeWrittenIsAFailure) {
  for (const std::string& path : {folder / "no/such/folder/s.h5", folder.fullDevice()}) {
    for (const bool fast : {true, false}) {
      std::vector<std::string> more = {"--seconds", "1", "--log", path};
      if (fast) more.push_back("--fast");
      const Ended ended = run(more);
      EXPECT_EQ(ended.code, 3) << path;
      EXPECT_THAT(ended.err, HasSubstr(path));
    }
  }
}

TEST_F(Run, RefusesAHandFileWithAHoleAndNamesTheLine) {
  const Ended cell = runHaptiv({"run", scene, "--fast", "--hand", data("hands/empty-cell.csv")});
  EXPECT_EQ(cell.code, 3);
  EXPECT_THAT(cell.err, HasSubstr("empty-cell.csv:4:"));
  const Ended hole = runHaptiv({"run", scene, "--fast", "--hand", data("hands/hole.csv")});
  EXPECT_EQ(hole.code, 3);
  EXPECT_THAT(hole.err, AnyOf(HasSubstr("hole.csv:21:"), HasSubstr("hole.csv:22:")));  // where it starts or ends
  const Ended missing = runHaptiv({"run", scene, "--fast", "--hand", folder / "missing.csv"});
  EXPECT_EQ(missing.code, 3);
  EXPECT_THAT(missing.err, HasSubstr("missing.csv"));
}

TEST_F(Run, AFaultIsNamedAndIsNotGood) {
  // A joint that is allowed no tracking error to speak of: the arm must stop.
  const std::string toml =
      folder.write("nervous.toml", "schema = 1\nname = \"nervous\"\n[control]\ntrackingErrorLimit = 1e-9\n");
  const std::string nervous =
      folder.write("nervous.iv", wallScene("", "HapticDevice { description \"" + toml + "\" }"));
  const Ended ended = runHaptiv({"run", nervous, "--hand", hand, "--fast", "--json"});
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("tracking"));
  EXPECT_EQ(ended.json()["faults"].size(), 1u) << ended.out;
}

TEST_F(Run, TheShippedLabyrinthRunsWithItsTour) {
  const std::string labyrinth = std::string(HAPTIV_SOURCE_DIR) + "/scenes/labyrinth.iv";
  const Ended ended = runHaptiv({"run", labyrinth, "--hand", data("hands/labyrinth-tour.csv"), "--fast", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_GE(ended.json()["contacts"].get<int>(), 1);
  EXPECT_EQ(ended.json()["faults"], Json::array());
}

}  // namespace haptiv
