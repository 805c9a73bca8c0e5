#include "app/timing/TimingPanel.h"

#include <gtest/gtest.h>

#include <QImage>

namespace haptiv {
namespace {

TimeDistribution all(std::int64_t time, int count) {
  TimeHistogram histogram;
  for (int i = 0; i < count; ++i) histogram.add(time);
  return histogram.distribution();
}

/// Mean column, in widths of the chart, of all pixels of this colour; -1: there is none.
double placeOf(QWidget& chart, const QColor& colour) {
  chart.resize(500, 200);
  const QImage image = chart.grab().toImage().convertToFormat(QImage::Format_RGB32);
  double sum = 0;
  int count = 0;
  for (int y = 0; y < image.height() * 3 / 4; ++y)
    for (int x = 0; x < image.width(); ++x)
      if (image.pixelColor(x, y) == colour) sum += x, ++count;
  return count > 0 ? sum / count / image.width() : -1;
}

TEST(TimingChart, LongerTimesLieFartherRight) {
  TimingChart chart;
  chart.show(all(1'000, 1000), {}, 0);
  const double early = placeOf(chart, TimingChart::wakeUpColour());
  chart.show(all(1'000'000, 1000), {}, 0);
  const double late = placeOf(chart, TimingChart::wakeUpColour());
  EXPECT_GT(early, 0);
  EXPECT_NEAR(late - early, 0.5, 0.06);  // three of six decades
}

TEST(TimingChart, ASingleLateTickIsSeen) {
  TimingChart chart;
  chart.show({}, all(20'000'000, 1), 1e6);
  chart.resize(500, 200);
  const QImage image = chart.grab().toImage().convertToFormat(QImage::Format_RGB32);
  int coloured = 0;
  for (int y = 0; y < image.height() * 9 / 10; ++y)
    for (int x = image.width() * 3 / 4; x < image.width(); ++x)
      if (image.pixelColor(x, y) == TimingChart::tickColour()) ++coloured;
  EXPECT_GT(coloured, 0);
}

TEST(TimingPanel, OffersTheRateWhereNoSessionRuns) {
  TimingPanel panel;
  double chosen = 0;
  QObject::connect(&panel, &TimingPanel::rateChosen, [&](double rate) { chosen = rate; });
  auto* rates = panel.findChild<QComboBox*>("sessionRate");
  EXPECT_EQ(rates->currentText(), "1000");
  emit rates->activated(rates->findText("8000"));
  EXPECT_EQ(chosen, 8000);
  panel.show({}, 0, 1000);
  EXPECT_FALSE(rates->isEnabled());
  panel.clear();
  EXPECT_TRUE(rates->isEnabled());
}

TEST(TimingPanel, SaysInWordsWhatTheServoDoes) {
  TimingPanel panel;
  SessionTiming timing;
  timing.wakeUps = all(12'000, 99);
  timing.ticks = all(5'000, 99);
  timing.processorShare = 0.123;
  panel.show(timing, 7, 1000);
  EXPECT_TRUE(panel.findChild<QLabel*>("timingWakeUps")->text().contains("12 us"));
  EXPECT_TRUE(panel.findChild<QLabel*>("timingTicks")->text().contains("5 us"));
  EXPECT_TRUE(panel.findChild<QLabel*>("timingShare")->text().contains("99 ticks, 7 missed"));
  EXPECT_TRUE(panel.findChild<QLabel*>("timingShare")->text().contains("12.3 %"));
  panel.clear();
  EXPECT_TRUE(panel.findChild<QLabel*>("timingShare")->text().isEmpty());
}

}  // namespace
}  // namespace haptiv
