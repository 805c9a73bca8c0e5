#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <thread>
#include <vector>

#include "device/realtime/TripleBuffer.h"
#include "haptics/realtime/RecordRing.h"
#include "device/realtime/TimeHistogram.h"

namespace haptiv {
namespace {

/// Content that follows from its seed: a value torn between two writes does not.
struct Seeded {
  Seeded() : Seeded(0) {}
  explicit Seeded(std::uint64_t newSeed) : seed(newSeed) {
    for (std::size_t i = 0; i < content.size(); ++i) content[i] = seed * 0x9e3779b97f4a7c15u + i;
  }
  bool whole() const { return content == Seeded(seed).content; }

  std::uint64_t seed;
  std::array<std::uint64_t, 64> content{};
};

TEST(TripleBuffer, GivesNothingNewUntilSomethingIsWritten) {
  TripleBuffer<int> buffer(7);
  EXPECT_FALSE(buffer.update());
  EXPECT_EQ(buffer.read(), 7);
  buffer.write(8);
  buffer.write(9);
  EXPECT_TRUE(buffer.update());
  EXPECT_EQ(buffer.read(), 9);
  EXPECT_FALSE(buffer.update());
  EXPECT_EQ(buffer.read(), 9);
}

TEST(TripleBuffer, NeverTearsAValueAndNeverGoesBack) {
  constexpr std::uint64_t kWrites = 100'000;
  TripleBuffer<Seeded> buffer;
  std::thread writer([&] {
    for (std::uint64_t seed = 1; seed <= kWrites; ++seed) buffer.write(Seeded(seed));
  });
  std::uint64_t last = 0;
  bool whole = true;
  bool forward = true;
  while (last < kWrites) {
    if (!buffer.update()) {
      std::this_thread::yield();
      continue;
    }
    whole = whole && buffer.read().whole();
    forward = forward && buffer.read().seed > last;
    last = buffer.read().seed;
  }
  writer.join();
  EXPECT_TRUE(whole);
  EXPECT_TRUE(forward);
}

/// Remembers on which thread it died.
struct DiesSomewhere {
  explicit DiesSomewhere(std::vector<std::thread::id>& where) : deaths(where) {}
  ~DiesSomewhere() { deaths.push_back(std::this_thread::get_id()); }
  std::vector<std::thread::id>& deaths;
};

TEST(TripleBuffer, LetsWhatIsDisplacedDieOnTheWritersSide) {
  constexpr int kWrites = 2000;
  std::vector<std::thread::id> deaths;  // only the writer's thread touches it while both run
  std::thread::id writerId;
  {
    TripleBuffer<std::shared_ptr<const DiesSomewhere>> buffer;
    std::atomic<bool> done = false;
    std::thread writer([&] {
      writerId = std::this_thread::get_id();
      for (int i = 0; i < kWrites; ++i) {
        buffer.write(std::make_shared<const DiesSomewhere>(deaths));
        if (i % 16 == 0) std::this_thread::yield();
      }
      done = true;
    });
    while (!done) buffer.update();
    writer.join();
    EXPECT_GE(deaths.size(), static_cast<std::size_t>(kWrites - 3));
    for (const std::thread::id& id : deaths) EXPECT_EQ(id, writerId);
  }
  EXPECT_EQ(deaths.size(), static_cast<std::size_t>(kWrites));
}

TEST(RecordRing, KeepsTheOrderAndCountsWhatItDrops) {
  RecordRing<int> ring(8);
  for (int i = 0; i < 11; ++i) ring.push(i);
  EXPECT_EQ(ring.dropped(), 3u);
  std::vector<int> got;
  EXPECT_EQ(ring.drain([&](int value) { got.push_back(value); }), 8u);
  EXPECT_EQ(got, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
  ring.push(12);
  got.clear();
  ring.drain([&](int value) { got.push_back(value); });
  EXPECT_EQ(got, std::vector<int>{12});
}

TEST(RecordRing, LosesNothingThatItDoesNotCountBetweenTwoThreads) {
  constexpr std::uint64_t kPushes = 200'000;
  RecordRing<std::uint64_t> ring(64);
  std::atomic<bool> done = false;
  std::thread writer([&] {
    for (std::uint64_t i = 1; i <= kPushes; ++i) ring.push(i);
    done = true;
  });
  std::uint64_t last = 0;
  std::uint64_t got = 0;
  bool forward = true;
  const auto take = [&](std::uint64_t value) {
    forward = forward && value > last;
    last = value;
    ++got;
  };
  while (!done) ring.drain(take);
  writer.join();
  ring.drain(take);
  EXPECT_TRUE(forward);
  EXPECT_EQ(got + ring.dropped(), kPushes);
}

TEST(TimeHistogram, HasBinsWithoutGapsASixteenthWide) {
  EXPECT_EQ(TimeHistogram::binOf(-5), 0u);
  EXPECT_EQ(TimeHistogram::binOf(std::int64_t{1} << 62), TimeHistogram::kBins - 1);
  for (std::size_t bin = 0; bin < TimeHistogram::kBins; ++bin) {
    const std::int64_t begin = TimeHistogram::beginOf(bin);
    const std::int64_t end = TimeHistogram::beginOf(bin + 1);
    EXPECT_EQ(TimeHistogram::binOf(begin), bin);
    EXPECT_EQ(TimeHistogram::binOf(end - 1), bin);
    EXPECT_LE(end - begin, std::max<std::int64_t>(1, begin / 16));
  }
}

TEST(TimeHistogram, GivesQuantilesToASixteenthAndTheLongestExactly) {
  TimeHistogram histogram;
  EXPECT_EQ(histogram.distribution().quantile(0.5), 0);
  for (std::int64_t time = 1; time <= 10'000; ++time) histogram.add(1000 * time);
  const TimeDistribution times = histogram.distribution();
  EXPECT_EQ(times.total, 10'000u);
  EXPECT_EQ(times.longest, 10'000'000);
  for (const double part : {0.5, 0.99, 0.999}) {
    EXPECT_GE(times.quantile(part), 10'000'000 * part);
    EXPECT_LE(times.quantile(part), 10'000'000 * part * 17 / 16);
  }
  EXPECT_EQ(times.quantile(1), 10'000'000);
}

TEST(TimeHistogram, CountsEveryTimeWhileAnotherThreadLooks) {
  constexpr std::int64_t kTimes = 200'000;
  TimeHistogram histogram;
  std::thread writer([&] {
    for (std::int64_t time = 0; time < kTimes; ++time) histogram.add(time);
  });
  std::uint64_t last = 0;
  bool forward = true;
  while (last < kTimes) {
    const std::uint64_t total = histogram.distribution().total;
    forward = forward && total >= last;
    last = total;
    std::this_thread::yield();
  }
  writer.join();
  EXPECT_TRUE(forward);
  EXPECT_EQ(histogram.distribution().total, static_cast<std::uint64_t>(kTimes));
}

}  // namespace
}  // namespace haptiv
