#include "device/DeviceTime.h"

#include <gtest/gtest.h>

#include <limits>

namespace haptiv {
namespace {

constexpr double kTick = 1e-3;  // [s]

TEST(DeviceTime, IsWhatTheClockTells) {
  EXPECT_DOUBLE_EQ(timeBetween(5000, 6000, kTick), 1e-3);
  EXPECT_DOUBLE_EQ(timeBetween(5000, 8125, kTick), 3.125e-3);
  EXPECT_EQ(timeBetween(5000, 5000, kTick), 0);  // the same reading again
}

TEST(DeviceTime, IsAPeriodWithoutAClockToBelieve) {
  constexpr std::int64_t kLast = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(timeBetween(0, 6000, kTick), kTick);
  EXPECT_EQ(timeBetween(5000, 0, kTick), kTick);
  EXPECT_EQ(timeBetween(5000, 4000, kTick), kTick);    // begun anew
  EXPECT_EQ(timeBetween(5000, 205000, kTick), kTick);  // no device is silent for so long
  EXPECT_EQ(timeBetween(5000, kLast, kTick), kTick);
  EXPECT_EQ(timeBetween(kLast, -kLast, kTick), kTick);
}

}  // namespace
}  // namespace haptiv
