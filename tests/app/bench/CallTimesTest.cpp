#include "app/bench/measuring/CallTimes.h"

#include <gtest/gtest.h>

namespace haptiv {
namespace {

TEST(CallTimes, CountEveryCallAndGiveWhatItReturns) {
  CallTimes times(10);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(times.time([&] { return i * i; }), i * i);
  times.endPass();
  times.endPass();  // a pass without calls is none
  EXPECT_EQ(times.calls(), 10u);
  EXPECT_GE(times.median(), 0);
  EXPECT_LE(times.median(), times.p99());
}

TEST(CallTimes, WithoutCallsAreZero) {
  EXPECT_EQ(CallTimes(1).median(), 0);
}

TEST(Quantile, LeavesThatPartBelow) {
  std::vector<double> values;
  for (int i = 100; i >= 0; --i) values.push_back(i);
  EXPECT_EQ(quantile(values, 0.5), 50);
  EXPECT_EQ(quantile(values, 0.99), 99);
  EXPECT_EQ(quantile(values, 0), 0);
}

}  // namespace
}  // namespace haptiv
