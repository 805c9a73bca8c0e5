#include "scenegraph/isolation/Isolated.h"

#include <gmock/gmock.h>
#include <signal.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <stdexcept>

#include "tests/scenegraph/SceneTesting.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(Isolated, BringsBackAResultOfAnySize) {
  const std::string large(10 << 20, 'x');
  const Isolated ended = runIsolated([&] { return large; });
  EXPECT_EQ(ended.result, large);
  EXPECT_THAT(ended.fault, IsEmpty());
}

TEST(Isolated, SurvivesACrashAndSaysWhereItWas) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGKILL}) {
    const Isolated ended = runIsolated([&] {
      tellProgress("reads a cube", 7);
      ::raise(signal);
      return std::string("never");
    });
    EXPECT_THAT(ended.fault, HasSubstr("while it reads a cube"));
    EXPECT_EQ(ended.line, 7);
    EXPECT_THAT(ended.result, IsEmpty());
  }
}

TEST(Isolated, TellsAnExceptionAsAFault) {
  EXPECT_EQ(runIsolated([]() -> std::string { throw std::runtime_error("no cube"); }).fault, "no cube");
}

TEST(Isolated, EndsWhatDoesNotEnd) {
  const Isolated ended = runIsolated(
      [] {
        tellProgress("counts");
        for (std::atomic<unsigned> count = 0;; ++count) {
        }
        return std::string("never");
      },
      std::chrono::seconds(1));
  EXPECT_THAT(ended.fault, HasSubstr("takes longer than 1 s while it counts"));
}

TEST(Isolated, EndsAPartThatTakesLongerThanItMay) {
  const Isolated ended = runIsolated([] {
    tellProgress("cuts", 3);
    allowTime(std::chrono::seconds(1));
    for (volatile bool goesOn = true; goesOn;) {
    }
    return std::string();
  });
  EXPECT_THAT(ended.fault, HasSubstr("takes longer than"));
  EXPECT_EQ(ended.line, 3);
}

TEST(Isolated, OpensNoFile) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizers need files of their own";
#endif
  const std::string file = testing::sourceDir() / "scenes/labyrinth.iv";
  ASSERT_TRUE(std::ifstream(file).is_open());
  const Isolated ended = runIsolated([&] {
    const bool before = std::ifstream(file).is_open();
    const FilesAllowed here;
    return std::string(before ? "open" : "shut") + (std::ifstream(file).is_open() ? ", open" : ", shut");
  });
  EXPECT_EQ(ended.result, "shut, open");
}

TEST(Isolated, LeavesNothingBehind) {
  int changed = 0;
  runIsolated([&] { return std::to_string(++changed); });
  EXPECT_EQ(changed, 0);
}

TEST(UnknownNodes, AreNotLookedForAmongTheSystemsLibraries) {
  // libhdf5-dev, which the program needs elsewhere, has a library of this name that nothing here is linked to.
  const SceneFile scene = readSceneText("#Inventor V2.1 ascii\nlibhdf5_serial_hl { }", "test.iv");
  EXPECT_FALSE(scene.root);
  std::ifstream maps("/proc/self/maps");
  const std::string loaded{std::istreambuf_iterator<char>(maps), {}};
  EXPECT_THAT(loaded, HasSubstr("libCoin"));
  EXPECT_THAT(loaded, Not(HasSubstr("libhdf5_serial_hl")));
}

}  // namespace
}  // namespace haptiv
