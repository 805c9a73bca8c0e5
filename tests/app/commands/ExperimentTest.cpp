#include <gtest/gtest.h>

#include <QImage>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <set>
#include <thread>

#include "tests/app/commands/HaptivProgram.h"

namespace haptiv {
namespace {

namespace fs = std::filesystem;

std::set<std::string> filesIn(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

// The quickest that is whole: five circles of one strategy.
Ended someCircles(const std::string& out) {
  return runHaptiv({"experiment", "circle", "--strategy", "nonopt", "--solution", "partitioned", "--out", out});
}

TEST(ExperimentCommand, WritesTablesFiguresAndClaimsWithoutADisplayAndTheSameAgain) {
  const TestFolder folder;
  const std::string out = folder / "new" + "/deep";
  const Ended ended = someCircles(out);
  ASSERT_EQ(ended.code, 0) << ended.err;
  const std::set<std::string> expected = {"circle-partitioned-nonopt-r0.05.csv",
                                          "circle-partitioned-nonopt-r0.20.csv",
                                          "circle-partitioned-nonopt-r0.40.csv",
                                          "circle-partitioned-nonopt-r0.60.csv",
                                          "circle-partitioned-nonopt-r0.80.csv",
                                          "claims.json",
                                          "claims.md",
                                          "fig11-circle-partitioned-r0.80.png",
                                          "fig13-circle-partitioned-means.png"};
  EXPECT_EQ(filesIn(out), expected);
  EXPECT_NE(ended.out.find("seen      Partitioned solution, nonopt: the rotational index is constant"),
            std::string::npos);
  EXPECT_NE(ended.err.find("5/5 circle-partitioned-nonopt-r0.80"), std::string::npos) << ended.err;

  const QImage figure(QString::fromStdString(out + "/fig11-circle-partitioned-r0.80.png"));
  EXPECT_EQ(figure.size(), QSize(1280, 720));
  std::set<QRgb> colours;
  for (int x = 0; x < figure.width(); ++x) colours.insert(figure.pixel(x, 360));
  EXPECT_GT(colours.size(), 3u) << "a blank figure";

  ASSERT_EQ(someCircles(folder / "again").code, 0);
  for (const std::string& name : expected)
    EXPECT_EQ(readFile(out + "/" + name), readFile(folder / "again/" + name)) << name << " is another the second time";
}

TEST(ExperimentCommand, RefusesNamesThatAreNotThereAndSaysWhichAre) {
  const TestFolder folder;
  const Ended strategy = runHaptiv({"experiment", "circle", "--strategy", "best", "--out", folder / "x"});
  EXPECT_EQ(strategy.code, 2);
  EXPECT_NE(strategy.err.find("nonopt, man, dir, cond"), std::string::npos) << strategy.err;
  const Ended solution = runHaptiv({"experiment", "circle", "--solution", "half", "--out", folder / "x"});
  EXPECT_EQ(solution.code, 2);
  EXPECT_NE(solution.err.find("full, partitioned"), std::string::npos) << solution.err;
  EXPECT_EQ(runHaptiv({"experiment", "squares", "--out", folder / "x"}).code, 2);
  EXPECT_EQ(runHaptiv({"experiment", "circle"}).code, 2) << "--out is missing";
  EXPECT_FALSE(fs::exists(folder / "x"));
}

TEST(ExperimentCommand, SaysWhyAFolderCannotBeWritten) {
  const TestFolder folder;
  const std::string file = folder.write("file", "");
  for (const std::string& out : {file, file + "/below"}) {
    const Ended ended = runHaptiv({"experiment", "circle", "--out", out});
    EXPECT_EQ(ended.code, 3) << out;
    EXPECT_NE(ended.err.find(out), std::string::npos) << ended.err;
  }
}

TEST(ExperimentCommand, LeavesOnlyWholeFilesWhenInterrupted) {
  const TestFolder folder;
  const std::string out = folder / "out";
  HaptivProgram program({"experiment", "all", "--out", out});
  const std::string second = out + "/circle-full-nonopt-r0.20.csv";
  for (int i = 0; i < 3000 && !fs::exists(second); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  program.send(SIGINT);
  EXPECT_EQ(program.wait().code, 128 + SIGINT);
  for (const std::string& name : filesIn(out)) {
    const std::string text = readFile(out + "/" + name);
    EXPECT_TRUE(name.ends_with(".csv") && text.ends_with("\n")) << name;
    const bool oneTurn = name.ends_with("r0.20.csv");  // of 1.257 s
    EXPECT_TRUE(!oneTurn || text.find("\n1.257,") != std::string::npos) << "the last row";
  }
}

}  // namespace
}  // namespace haptiv
