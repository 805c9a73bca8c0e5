#include "app/replay/CurveLoader.h"

#include <gtest/gtest.h>

#include <QTest>
#include <algorithm>

#include "tests/app/replay/TestLog.h"

namespace haptiv {
namespace {

void load(CurveLoader& loader, const SessionLog& log) {
  loader.start(log);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !loader.isLoading(); }, kLongEnough));
}

TEST(CurveLoader, BringsEveryTickOfAShortLog) {
  TestLogs logs;
  auto ticks = testTicks(2'500);
  ticks[2'000].passivityEnergy = -0.25;
  const SessionLog log = logs.make(ticks);
  CurveLoader loader;
  load(loader, log);
  const Curves force = loader.force();
  const Curves position = loader.position();
  ASSERT_EQ(force.times.size(), 2'500u);
  EXPECT_DOUBLE_EQ(force.times[2'000], 2.0);
  EXPECT_DOUBLE_EQ(force.samples[0][2'000], 4.0);  // the norm of the environment's
  EXPECT_DOUBLE_EQ(force.samples[1][2'000], 2.0);  // the norm of the hand's
  EXPECT_DOUBLE_EQ(position.samples[1][2'000], -2.0);
  EXPECT_DOUBLE_EQ(loader.energy().samples[0][2'000], -0.25);
}

TEST(CurveLoader, ThinsALongLogButKeepsItsPeakAndShowsItFinerOnDemand) {
  auto ticks = testTicks(60'000);
  for (TickRecord& tick : ticks) tick.environmentForce.setZero();
  ticks[30'001].environmentForce = Vector3(0, 0, 25);
  TestLogs logs;
  const SessionLog log = logs.make(ticks);
  CurveLoader loader;
  load(loader, log);
  const Curves overview = loader.force();
  EXPECT_LT(overview.times.size(), ticks.size() / 2);
  EXPECT_EQ(*std::max_element(overview.samples[0].begin(), overview.samples[0].end()), 25);

  loader.refine(29.9, 30.1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !loader.isLoading(); }, kLongEnough));
  const Curves finer = loader.force();
  EXPECT_TRUE(std::is_sorted(finer.times.begin(), finer.times.end()));
  const auto peak = std::max_element(finer.samples[0].begin(), finer.samples[0].end()) - finer.samples[0].begin();
  EXPECT_NEAR(finer.times[static_cast<std::size_t>(peak)], 30.001, 1e-9);  // to the tick
  EXPECT_EQ(std::count_if(finer.times.begin(), finer.times.end(), [](double t) { return t > 29.9495 && t < 30.0505; }),
            101);
  EXPECT_EQ(finer.times.back(), overview.times.back());
}

}  // namespace
}  // namespace haptiv
