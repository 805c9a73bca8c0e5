#include "device/usb/spacemouse/SpaceMouseReport.h"

#include <gtest/gtest.h>

#include <vector>

#include "device/usb/spacemouse/SpaceMouseModels.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

using Axes = std::array<std::int16_t, 6>;

SpaceMouseState after(const std::vector<std::vector<std::uint8_t>>& reports) {
  SpaceMouseState state;
  for (const auto& report : reports) takeReport(report, 5, state);
  return state;
}

TEST(SpaceMouseReport, TellsTranslationAndRotationApart) {
  // 350 is 015e, -350 fea2.
  const SpaceMouseState state =
      after({{1, 0x5e, 0x01, 0xa2, 0xfe, 0x07, 0x00}, {2, 0x01, 0x00, 0xff, 0xff, 0x00, 0x01}});
  EXPECT_EQ(state.axes, (Axes{350, -350, 7, 1, -1, 256}));
  EXPECT_EQ(state.reports, 2u);
  EXPECT_EQ(state.ignored, 0u);
  EXPECT_EQ(state.time, 5);
}

TEST(SpaceMouseReport, TakesSixAxesOfOneReportAsTheWirelessOnesSendThem) {
  const SpaceMouseState state = after({{1, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0}});
  EXPECT_EQ(state.axes, (Axes{1, 2, 3, 4, 5, 6}));
}

TEST(SpaceMouseReport, ARotationReportHasThreeAxesHoweverLongItIs) {
  const SpaceMouseState state = after({{1, 9, 0, 9, 0, 9, 0}, {2, 4, 0, 5, 0, 6, 0, 7, 0, 8, 0, 9, 0}});
  EXPECT_EQ(state.axes, (Axes{9, 9, 9, 4, 5, 6}));
}

TEST(SpaceMouseReport, ButtonsAreBitsInOneByteOrFour) {
  EXPECT_EQ(after({{3, 0x03}}).buttons, 3u);
  EXPECT_EQ(after({{3, 0x01, 0x00, 0x40, 0x80}}).buttons, 0x80400001u);
  EXPECT_EQ(after({{3, 0x01, 0, 0, 0, 0xff, 0xff}}).buttons, 1u) << "bits beyond 32 belong to no button that is asked";
  EXPECT_EQ(after({{3, 0x03}, {3, 0x00}}).buttons, 0u);
}

TEST(SpaceMouseReport, WhatIsShortOrStrangeChangesNothingAndIsCounted) {
  const std::vector<std::uint8_t> good = {1, 1, 0, 2, 0, 3, 0};
  for (const std::vector<std::uint8_t>& bad : std::vector<std::vector<std::uint8_t>>{
           {}, {1}, {2}, {3}, {1, 9}, {1, 9, 9, 9, 9, 9}, {2, 9, 9, 9, 9, 9}, {0, 9, 9, 9, 9, 9, 9}, {0x17, 50}}) {
    const SpaceMouseState before = after({good});
    const SpaceMouseState state = after({good, bad});
    EXPECT_EQ(state.axes, before.axes);
    EXPECT_EQ(state.buttons, before.buttons);
    EXPECT_EQ(state.reports, 1u);
    EXPECT_EQ(state.ignored, 1u);
  }
}

TEST(SpaceMouseReport, EveryReportOfAnyBytesIsUnderstoodOrCounted) {
  test::Random random(1);
  SpaceMouseState state;
  constexpr unsigned kReports = 20000;
  for (unsigned i = 0; i < kReports; ++i) {
    std::vector<std::uint8_t> report(static_cast<std::size_t>(random.between(0, 65)));
    for (auto& byte : report) byte = static_cast<std::uint8_t>(random.between(0, 256));
    if (!report.empty() && random.between(0, 1) < 0.7) report[0] = static_cast<std::uint8_t>(random.between(0, 5));
    takeReport(report, i, state);
  }
  EXPECT_EQ(state.reports + state.ignored, kReports);
  EXPECT_GT(state.reports, 0u);
  EXPECT_GT(state.ignored, 0u);
}

TEST(SpaceMouseModels, AreFoundByTheirNumbers) {
  ASSERT_NE(spaceMouseModel(0x046d, 0xc626), nullptr);
  EXPECT_EQ(spaceMouseModel(0x046d, 0xc626)->name, "SpaceNavigator");
  ASSERT_NE(spaceMouseModel(0x256f, 0xc635), nullptr);
  EXPECT_EQ(spaceMouseModel(0x046d, 0xc077), nullptr) << "a mouse";
  for (const SpaceMouseModel& model : spaceMouseModels())
    EXPECT_EQ(spaceMouseModel(model.vendor, model.product), &model) << "no two of the same numbers";
}

}  // namespace
}  // namespace haptiv
