/// That ThreadSanitizer sees what it is there for: two threads at one variable, with nothing between them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

namespace haptiv {
namespace {

constexpr int kExitCodeOfThreadSanitizer = 66;  // its own, where it has told of a race

[[noreturn]] void race() {
  int shared = 0;
  std::thread other([&] { ++shared; });
  ++shared;
  other.join();
  std::exit(shared == 0);
}

TEST(ThreadSanitizer, SeesAPlantedRace) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(race(), ::testing::ExitedWithCode(kExitCodeOfThreadSanitizer), "data race");
}

}  // namespace
}  // namespace haptiv
