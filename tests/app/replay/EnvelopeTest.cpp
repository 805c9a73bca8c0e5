#include "app/plots/samples/Envelope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace haptiv {
namespace {

std::vector<double> noise(std::size_t count, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values(count);
  for (double& value : values) value = normal(generator);
  return values;
}

TEST(Envelope, KeepsTheMinimumAndTheMaximumOfEachBucket) {
  constexpr std::size_t kCount = 10'007;  // a prime: the last bucket is not full
  constexpr std::size_t kBucket = 100;
  const std::vector<double> values = noise(kCount, 1);
  Envelope envelope(1, kBucket);
  for (std::size_t k = 0; k < kCount; ++k) envelope.add(static_cast<double>(k), {&values[k], 1});
  envelope.finish();

  ASSERT_EQ(envelope.times().size(), 2 * ((kCount + kBucket - 1) / kBucket));
  for (std::size_t b = 0; b < envelope.times().size() / 2; ++b) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(b * kBucket);
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(std::min((b + 1) * kBucket, kCount));
    const auto [least, greatest] = std::minmax_element(begin, end);
    const double first = envelope.samples()[0][2 * b];
    const double second = envelope.samples()[0][2 * b + 1];
    EXPECT_EQ(std::min(first, second), *least) << "bucket " << b;
    EXPECT_EQ(std::max(first, second), *greatest) << "bucket " << b;
    EXPECT_EQ(first == *least, least < greatest) << "the extremes of bucket " << b << " are not in their order";
  }
}

TEST(Envelope, KeepsAShortPeakAmongManySamples) {
  Envelope envelope(1, 1000);
  for (int k = 0; k < 100'000; ++k) {
    const double value = k == 54'321 ? 7.0 : 0.0;
    envelope.add(k * 1e-3, {&value, 1});
  }
  const auto& samples = envelope.samples()[0];
  const auto peak = std::max_element(samples.begin(), samples.end());
  EXPECT_EQ(*peak, 7.0);
  // Within its bucket of a second.
  EXPECT_NEAR(envelope.times()[static_cast<std::size_t>(peak - samples.begin())], 54.321, 1.0);
}

TEST(Envelope, LeavesFewSamplesAsTheyAre) {
  const std::vector<double> values = noise(500, 2);
  Envelope envelope(1, 1);
  for (std::size_t k = 0; k < values.size(); ++k) envelope.add(static_cast<double>(k), {&values[k], 1});
  EXPECT_EQ(envelope.samples()[0], values);
}

TEST(Envelope, LeavesOutWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  Envelope envelope(1, 4);
  for (const double value : {nan, 1.0, -infinite, 3.0, nan, nan, infinite, nan}) envelope.add(0, {&value, 1});
  ASSERT_EQ(envelope.samples()[0].size(), 4u);
  EXPECT_EQ(envelope.samples()[0][0], 1.0);
  EXPECT_EQ(envelope.samples()[0][1], 3.0);
  EXPECT_TRUE(std::isnan(envelope.samples()[0][2]));
  EXPECT_TRUE(std::isnan(envelope.samples()[0][3]));
}

}  // namespace
}  // namespace haptiv
