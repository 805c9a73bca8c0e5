#include "app/plots/samples/CalmRange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace haptiv {
namespace {

TEST(CalmRange, HoldsWhatIsFittedIntoIt) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> value(-1, 1);
  std::uniform_real_distribution<double> exponent(-6, 6);
  CalmRange range(1e-3);
  for (int i = 0; i < 1000; ++i) {
    const double scale = std::pow(10, exponent(generator));
    const double a = value(generator) * scale;
    const double b = value(generator) * scale;
    range.fit(std::min(a, b), std::max(a, b));
    ASSERT_LE(range.lower(), std::min(a, b));
    ASSERT_GE(range.upper(), std::max(a, b));
    ASSERT_GE(range.upper() - range.lower(), 1e-3);
  }
}

TEST(CalmRange, DoesNotBlowUpNoise) {
  CalmRange range(1);
  range.fit(4.99, 5.01);
  EXPECT_GE(range.upper() - range.lower(), 1);
}

TEST(CalmRange, StaysWhileTheValuesFitAndFillItFairly) {
  CalmRange range(1);
  range.fit(0, 10);
  const double upper = range.upper();
  range.fit(0, 8);
  EXPECT_EQ(range.upper(), upper);
  range.fit(0, 5);
  EXPECT_EQ(range.upper(), upper);
}

TEST(CalmRange, NarrowsWhereMuchWouldBeEmpty) {
  CalmRange range(1);
  range.fit(0, 100);
  range.fit(0, 3);
  EXPECT_LT(range.upper(), 10);
}

TEST(CalmRange, StandsOnZeroForWhatIsNeverNegative) {
  CalmRange range(1);
  range.fit(0.1, 20);
  EXPECT_EQ(range.lower(), 0);
}

}  // namespace
}  // namespace haptiv
