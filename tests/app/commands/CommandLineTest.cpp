#include <gmock/gmock.h>
#include <sys/stat.h>

#include "tests/app/commands/HaptivProgram.h"
#include "tests/app/commands/TestFolder.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

void expectWrongUsage(const std::vector<std::string>& arguments, const std::string& named) {
  const Ended ended = runHaptiv(arguments);
  EXPECT_EQ(ended.code, 2) << ended.err;
  EXPECT_THAT(ended.err, StartsWith("haptiv: "));
  EXPECT_THAT(ended.err, HasSubstr(named));
  EXPECT_EQ(ended.out, "");
}

}  // namespace

TEST(CommandLine, TellsItsVersion) {
  const Ended ended = runHaptiv({"--version"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, StartsWith("haptiv 0."));
}

TEST(CommandLine, HelpShowsTheCommandsOfThisVersionAndExamples) {
  const Ended ended = runHaptiv({"--help"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.err, "");
  for (const char* there : {"run", "check", "replay", "generate", "experiment", "info", "kinematics", "bench", "device",
                            "Examples:", "Exit codes"})
    EXPECT_THAT(ended.out, HasSubstr(there));
}

TEST(CommandLine, HelpOfEachCommandIsGood) {
  for (const char* command : {"run", "check", "replay", "info", "kinematics"}) {
    const Ended ended = runHaptiv({command, "--help"});
    EXPECT_EQ(ended.code, 0) << command;
    EXPECT_THAT(ended.out, HasSubstr("--json")) << command;
  }
}

TEST(CommandLine, RefusesWrongUsageWithTwoAndNamesIt) {
  expectWrongUsage({"run"}, "SCENE");
  expectWrongUsage({"run", "s.iv", "--colour"}, "--colour");
  expectWrongUsage({"run", "s.iv", "--rate", "499"}, "499");
  expectWrongUsage({"run", "s.iv", "--rate", "8001"}, "8001");
  expectWrongUsage({"run", "s.iv", "--rate", "nan"}, "nan");
  expectWrongUsage({"run", "s.iv", "--rate", "fast"}, "fast");
  expectWrongUsage({"run", "s.iv", "--seconds", "0"}, "0");
  expectWrongUsage({"run", "s.iv", "--seconds", "-1"}, "-1");
  expectWrongUsage({"run", "s.iv", "--seconds", "nan"}, "nan");
  expectWrongUsage({"run", "s.iv", "--log", ""}, "--log");
  expectWrongUsage({"run", "s.iv", "--device", "hammer"}, "hammer");
  expectWrongUsage({"run", "s.iv", "--strategy", "best"}, "nonopt");  // what there is
  expectWrongUsage({"run", "s.iv", "--control", "best"}, "position-impedance");
  expectWrongUsage({"run", "s.iv", "--solution", "half"}, "partitioned");
  expectWrongUsage({"check"}, "SCENE");
  expectWrongUsage({"info"}, "LOG");
  expectWrongUsage({"replay"}, "LOG");
  expectWrongUsage({"kinematics"}, "--q");
  expectWrongUsage({"s.iv", "check", "s.iv"}, "s.iv");
}

TEST(CommandLine, TellsThatNoBoardIsPluggedIn) {
  const TestFolder folder;
  const std::string scene = folder.write("wall.iv", wallScene());
  for (const char* device : {"usb", "usb:no-such-board"}) {
    const Ended ended = runHaptiv({"run", scene, "--device", device, "--seconds", "0.1"});
    EXPECT_EQ(ended.code, 3) << device;
    EXPECT_THAT(ended.err, HasSubstr("Haptiv interface board"));
  }
  EXPECT_EQ(runHaptiv({"device", "monitor", "--device", "usb:no-such-board", "--seconds", "1"}).code, 3);
}

TEST(CommandLine, RefusesAHandAndAClockThatABoardHasItself) {
  expectWrongUsage({"run", "s.iv", "--device", "usb", "--fast"}, "--fast");
  expectWrongUsage({"run", "s.iv", "--device", "usb", "--hand", "h.csv"}, "--hand");
  expectWrongUsage({"device", "monitor", "--device", "sim"}, "usb");
}

TEST(CommandLine, WithoutDisplayTheWindowSaysWhatToDoInstead) {
  const TestFolder folder;
  const std::string scene = folder.write("wall.iv", wallScene());
  const Ended ended = runHaptiv({scene});
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("haptiv run " + scene));
  EXPECT_THAT(ended.err, HasSubstr("--picture"));
  EXPECT_EQ(runHaptiv({}).code, 3);
}

TEST(CommandLine, NamesAFileThatIsNotThere) {
  const std::string missing = TestFolder() / "missing.iv";
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{missing},
                                                    {"run", missing},
                                                    {"check", missing},
                                                    {"info", missing},
                                                    {"replay", missing, "--verify"},
                                                    {"replay", missing, "--verify", "--json"}}) {
    const Ended ended = runHaptiv(arguments);
    EXPECT_EQ(ended.code, 3) << arguments.front();
    EXPECT_THAT(ended.err, HasSubstr(missing));
    EXPECT_EQ(ended.out, "");
  }
}

/// Opening one would wait for who writes to it.
TEST(CommandLine, RefusesAPipeInThePlaceOfAFile) {
  const TestFolder folder;
  const std::string pipe = folder / "pipe.iv";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string scene = folder.write("wall.iv", wallScene());
  const std::vector<std::vector<std::string>> commands = {
      {"check", pipe}, {"run", pipe}, {"run", scene, "--hand", pipe}, {"replay", pipe, "--verify"},
      {"info", pipe},  {pipe}};
  for (const std::vector<std::string>& command : commands) {
    const Ended ended = runHaptiv(command);
    EXPECT_EQ(ended.code, 3) << command.front();
    EXPECT_THAT(ended.err, HasSubstr(pipe + ": this is a pipe; name a file")) << command.front();
  }
}

TEST(CommandLine, SaysWhenStandardOutputIsFull) {
  HaptivProgram program({"kinematics", "--q", "0,0,0,0,0,0,0,0,0,0", "--json"}, "/dev/full");
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("standard output"));
}

}  // namespace haptiv
