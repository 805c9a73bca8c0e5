#include "app/replay/LogReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/app/replay/TestLog.h"

namespace haptiv {
namespace {

/// The same by looking at all of them.
std::uint64_t newestAt(const std::vector<TickRecord>& ticks, std::int64_t time) {
  const auto after = std::find_if(ticks.begin(), ticks.end(), [&](const TickRecord& t) { return t.time > time; });
  return after == ticks.begin() ? 0 : static_cast<std::uint64_t>(after - ticks.begin()) - 1;
}

TEST(LogReader, FindsTheNewestTickAtAnyTimeAmongMissedOnes) {
  // Single ticks, a stretch within a block, and several blocks at once are missing; and the beginning.
  const auto ticks = testTicks(12'000, [](std::uint64_t tick) {
    return tick < 5 || tick % 97 == 3 || (tick > 700 && tick < 900) || (tick > 3'000 && tick < 7'500);
  });
  TestLogs logs;
  const SessionLog log = logs.make(ticks);
  LogReader reader(log);
  std::mt19937 generator(4);
  std::uniform_int_distribution<std::int64_t> time(-1'000'000, 12'001'000'000);
  for (int i = 0; i < 2'000; ++i) {
    const std::int64_t t = time(generator);
    ASSERT_EQ(reader.indexAt(t), newestAt(ticks, t)) << "at " << t << " ns";
  }
}

TEST(LogReader, FindsEveryTickAtItsOwnTime) {
  const auto ticks = testTicks(3'500, [](std::uint64_t tick) { return tick % 10 == 7; });
  TestLogs logs;
  const SessionLog log = logs.make(ticks);
  LogReader reader(log);
  for (std::uint64_t i = 0; i < ticks.size(); ++i) {
    ASSERT_EQ(reader.indexAt(ticks[i].time), i);
    ASSERT_EQ(reader.at(i).tick, ticks[i].tick);
  }
}

}  // namespace
}  // namespace haptiv
