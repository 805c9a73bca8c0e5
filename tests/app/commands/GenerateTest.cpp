#include <gmock/gmock.h>

#include "tests/app/commands/HaptivProgram.h"
#include "tests/app/commands/TestFolder.h"

namespace haptiv {

using ::testing::HasSubstr;

TEST(Generate, MakesAMazeThatAHandGoesThrough) {
  const TestFolder folder;
  const std::string scene = folder / "maze.iv";
  const std::string hand = folder / "way.csv";
  const Ended made =
      runHaptiv({"generate", "maze", "--cells", "4x3", "--seed", "7", "--out", scene, "--hand", hand, "--json"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(made.json()["walls"], 6 + 14);
  const Ended checked = runHaptiv({"check", scene, "--json"});
  EXPECT_EQ(checked.code, 0);
  EXPECT_EQ(checked.json()["walls"], 6 + 14);
  EXPECT_TRUE(checked.json()["warnings"].empty()) << checked.out;

  const Ended ran = runHaptiv({"run", scene, "--hand", hand, "--fast", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  // The goal is the middle of the cell in the north-east, 1.5 cells of 7 cm east and 1 north of the maze's middle. The
  // hand's spring pulls against the goal's medium, which yields, so the ball comes to rest there.
  EXPECT_NEAR(ran.json()["final_position_m"][0], 1.5 * 0.07, 0.002);
  EXPECT_NEAR(ran.json()["final_position_m"][1], 0.07, 0.002);
}

TEST(Generate, WritesTheSameForTheSameSeed) {
  const TestFolder folder;
  for (const std::string what : {"maze", "relief"}) {
    for (const std::string name : {"a.iv", "b.iv"})
      EXPECT_EQ(runHaptiv({"generate", what, "--cells", "9x8", "--out", folder / name}).code, 0);
    EXPECT_EQ(readFile(folder / "a.iv"), readFile(folder / "b.iv"));
  }
}

TEST(Generate, SaysWhatIsWrongWithWhatIsAskedFor) {
  const TestFolder folder;
  for (const std::string cells : {"9", "9x", "x9", "1x9", "9x9x9", "1001x9", "-9x9", "9 x 9", ""}) {
    const Ended ended = runHaptiv({"generate", "maze", "--cells", cells, "--out", folder / "m.iv"});
    EXPECT_EQ(ended.code, 2) << cells;
    EXPECT_THAT(ended.err, HasSubstr("--cells")) << cells;
  }
  EXPECT_EQ(runHaptiv({"generate", "maze"}).code, 2) << "without a file to write";
  EXPECT_EQ(runHaptiv({"generate"}).code, 2);
  EXPECT_EQ(runHaptiv({"generate", "maze", "--out", folder / "no/such/folder.iv"}).code, 3);
}

}  // namespace haptiv
