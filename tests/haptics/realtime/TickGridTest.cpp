#include "haptics/realtime/TickGrid.h"

#include <gtest/gtest.h>

#include <random>

namespace haptiv {
namespace {

TEST(TickGrid, GoesOnByOnePeriodWhereTheTickWasInTime) {
  TickGrid grid(5000, 1e6);
  EXPECT_EQ(grid.deadline(), 5000);
  EXPECT_EQ(grid.advance(5400), 0u);
  EXPECT_EQ(grid.index(), 1u);
  EXPECT_EQ(grid.deadline(), 6000);
  EXPECT_EQ(grid.advance(7000), 0u);  // on the spot is in time
  EXPECT_EQ(grid.deadline(), 7000);
}

TEST(TickGrid, SkipsWhatIsPastAndCountsIt) {
  TickGrid grid(0, 1e6);
  EXPECT_EQ(grid.advance(3500), 3u);
  EXPECT_EQ(grid.index(), 4u);
  EXPECT_EQ(grid.deadline(), 4000);
  EXPECT_EQ(grid.advance(7000), 2u);
  EXPECT_EQ(grid.deadline(), 7000);
}

TEST(TickGrid, DoesNotDriftAtRatesThatAreNoWholeNumberOfNanoseconds) {
  TickGrid grid(0, 3000);
  for (int i = 0; i < 3'000'000; ++i) grid.advance(grid.deadline());
  EXPECT_EQ(grid.deadline(), 1'000'000'000'000);
}

TEST(TickGrid, AccountsForEveryGridPointAndNeverCatchesUp) {
  std::mt19937 engine(1);
  for (const double rate : {1000.0, 3000.0, 8191.0}) {
    TickGrid grid(123, rate);
    std::uint64_t ticks = 0, missed = 0;
    std::int64_t now = 123;
    for (int i = 0; i < 20000; ++i) {
      now = std::max(now, grid.deadline()) + static_cast<std::int64_t>(engine() % 500'000);
      ++ticks;
      missed += grid.advance(now);
      EXPECT_EQ(grid.index(), ticks + missed);
      EXPECT_GE(grid.deadline(), now);
      EXPECT_TRUE(grid.timeOf(grid.index() - 1) < now || grid.timeOf(grid.index() - 2) < now);
    }
  }
}

}  // namespace
}  // namespace haptiv
