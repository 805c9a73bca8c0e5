#include "app/replay/ReplayBar.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "tests/app/replay/TestLog.h"

namespace haptiv {
namespace {

struct ShownBar {
  TestLogs logs;
  ReplayPlayer player;
  ReplayBar bar;
  QSlider* slider = bar.findChild<QSlider*>("timeSlider");
  QToolButton* play = bar.findChild<QToolButton*>("playButton");
  QComboBox* speed = bar.findChild<QComboBox*>("speedBox");
  SignalPlot* force = bar.findChild<SignalPlot*>("forcePlot");
  SignalPlot* position = bar.findChild<SignalPlot*>("positionPlot");
  SignalPlot* energy = bar.findChild<SignalPlot*>("energyPlot");

  explicit ShownBar(const std::vector<TickRecord>& ticks = testTicks(20'001),
                    TestLogs::End end = TestLogs::End::orderly, std::uint64_t dropped = 0)
      : player(logs.make(ticks, end, dropped)) {
    bar.resize(900, 220);
    bar.setPlayer(&player);
    bar.show();
    bar.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&bar));
    bar.setFocus();
  }
  QString label(const char* name) const { return bar.findChild<QLabel*>(name)->text(); }
  void expectAllAt(double time) const {
    EXPECT_NEAR(player.time(), time, 1e-9);
    EXPECT_EQ(slider->value(), std::lround(time * 1000));
    EXPECT_NEAR(force->cursor(), time, 1e-9);
    EXPECT_NEAR(position->cursor(), time, 1e-9);
    EXPECT_NEAR(energy->cursor(), time, 1e-9);
    EXPECT_EQ(label("timeLabel"), QString::number(time, 'f', 3) + " s / 20.000 s");
    EXPECT_EQ(label("tickLabel"), QString("tick %1").arg(std::lround(time * 1000)));
  }
};

TEST(ReplayBar, KeepsSliderPlotsAndPlayerInStepWhicheverIsMoved) {
  ShownBar s;
  s.expectAllAt(0);
  s.slider->setValue(3'214);
  s.expectAllAt(3.214);
  s.player.seek(7.5);
  s.expectAllAt(7.5);
  emit s.force->timePicked(11.25);
  s.expectAllAt(11.25);
  emit s.position->timePicked(1.125);
  s.expectAllAt(1.125);
}

TEST(ReplayBar, GoesWithThePlayerToTheEnd) {
  ShownBar s;
  s.player.seek(19.8);
  s.play->click();
  EXPECT_TRUE(s.player.isPlaying());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !s.player.isPlaying(); }, kLongEnough));
  s.expectAllAt(20);
}

TEST(ReplayBar, ObeysItsKeysWhereverItsFocusIs) {
  ShownBar s;
  for (QWidget* focused : {static_cast<QWidget*>(&s.bar), static_cast<QWidget*>(s.slider),
                           static_cast<QWidget*>(s.speed), static_cast<QWidget*>(s.force)}) {
    focused->setFocus();
    s.player.seek(5);
    QTest::keyClick(focused, Qt::Key_Right);
    s.expectAllAt(5.001);
    QTest::keyClick(focused, Qt::Key_Left, Qt::ShiftModifier);
    s.expectAllAt(4.991);
    QTest::keyClick(focused, Qt::Key_End);
    s.expectAllAt(20);
    QTest::keyClick(focused, Qt::Key_Home);
    s.expectAllAt(0);
    QTest::keyClick(focused, Qt::Key_Space);
    EXPECT_TRUE(s.player.isPlaying());
    QTest::keyClick(focused, Qt::Key_Space);
    EXPECT_FALSE(s.player.isPlaying());
  }
}

TEST(ReplayBar, SetsTheSpeedAndShowsIt) {
  ShownBar s;
  EXPECT_EQ(s.speed->currentText(), "1x");
  s.speed->setCurrentIndex(s.speed->findText("5x"));
  EXPECT_EQ(s.player.speed(), 5);
  s.player.setSpeed(0.25);
  EXPECT_EQ(s.speed->currentText(), "0.25x");
}

TEST(ReplayBar, SaysThatALogIsCompleteOrCutOffOrLostTicks) {
  EXPECT_EQ(ShownBar().label("stateLabel"), "complete");
  EXPECT_EQ(ShownBar(testTicks(2'000), TestLogs::End::cutOff).label("stateLabel"), "cut off");
  EXPECT_EQ(ShownBar(testTicks(2'000), TestLogs::End::orderly, 3).label("stateLabel"), "complete, 3 ticks lost");
}

TEST(ReplayBar, SharesTheZoomOfThePlotsAndFollowsTheCursor) {
  ShownBar s;
  s.force->setTimeRange(2, 4);
  emit s.force->timeRangeChanged(2, 4);
  EXPECT_EQ(s.position->timeRange(), std::pair(2.0, 4.0));
  s.player.seek(10);
  for (const SignalPlot* plot : {s.force, s.position}) {
    EXPECT_LE(plot->timeRange().first, 10);
    EXPECT_GE(plot->timeRange().second, 10);
    EXPECT_NEAR(plot->timeRange().second - plot->timeRange().first, 2, 1e-9);
  }
}

TEST(ReplayBar, IsEmptyAndDisabledWithoutAPlayer) {
  ShownBar s;
  s.player.seek(5);
  s.bar.setPlayer(nullptr);
  EXPECT_FALSE(s.play->isEnabled());
  EXPECT_FALSE(s.slider->isEnabled());
  EXPECT_EQ(s.label("timeLabel"), "");
  EXPECT_EQ(s.label("stateLabel"), "no log");
  s.slider->setValue(1);
  EXPECT_EQ(s.player.time(), 5);
}

TEST(ReplayBar, OutlivesItsPlayer) {
  TestLogs logs;
  ReplayBar bar;
  {
    ReplayPlayer player(logs.make(testTicks(5'000)));
    bar.setPlayer(&player);
    player.play();
  }
  QTest::qWait(50);
  EXPECT_FALSE(bar.findChild<QToolButton*>("playButton")->isEnabled());
}

}  // namespace
}  // namespace haptiv
