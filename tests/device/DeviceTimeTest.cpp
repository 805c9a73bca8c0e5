#include "device/DeviceTime.h"

#include <gtest/gtest.h>

#include <limits>

namespace haptiv {
namespace {

constexpr double kPeriod = 1e-3;  // [s]

TEST(DeviceTime, IsWhatTheClockTells) {
  EXPECT_DOUBLE_EQ(timeBetween(5000, 6000, kPeriod), 1e-3);
  EXPECT_DOUBLE_EQ(timeBetween(5000, 8125, kPeriod), 3.125e-3);
  EXPECT_EQ(timeBetween(5000, 5000, kPeriod), 0);  // the same reading again
}

TEST(DeviceTime, IsAPeriodWithoutAClockToBelieve) {
  constexpr std::int64_t kLast = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(timeBetween(0, 6000, kPeriod), kPeriod);
  EXPECT_EQ(timeBetween(5000, 0, kPeriod), kPeriod);
  EXPECT_EQ(timeBetween(5000, 4000, kPeriod), kPeriod);    // begun anew
  EXPECT_EQ(timeBetween(5000, 205000, kPeriod), kPeriod);  // no device is silent for so long
  EXPECT_EQ(timeBetween(5000, kLast, kPeriod), kPeriod);
  EXPECT_EQ(timeBetween(kLast, -kLast, kPeriod), kPeriod);
}

}  // namespace
}  // namespace haptiv
