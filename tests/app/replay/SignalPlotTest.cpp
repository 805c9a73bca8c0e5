#include "app/plots/SignalPlot.h"

#include <gtest/gtest.h>
#include <qwt_plot.h>

#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "app/plots/samples/Signals.h"

namespace haptiv {
namespace {

struct ShownPlot {
  SignalPlot plot{"Force [N]", {"environment", "hand"}};
  QwtPlot* qwt = plot.findChild<QwtPlot*>();

  ShownPlot() {
    plot.resize(500, 150);
    plot.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&plot));
  }
  /// Twenty seconds of two curves.
  void fill() {
    std::vector<double> times(20'001), a(times.size()), b(times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
      times[i] = static_cast<double>(i) * 1e-3;
      a[i] = std::sin(times[i]);
      b[i] = 0.3;
    }
    plot.setCurves(times, {a, b});
    QTest::qWait(50);
  }
  void wheel(QPoint at, int delta) {
    QWheelEvent event(at, qwt->canvas()->mapToGlobal(at), {}, {0, delta}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(qwt->canvas(), &event);
    QTest::qWait(50);
  }
};

TEST(Signals, DrawAtMostTwoPointsAColumnAndKeepTheExtremes) {
  Signals samples(1);
  for (int k = 0; k < 100'000; ++k) samples.append(k * 1e-3, {k == 77'777 ? -5.0 : k == 33'333 ? 9.0 : 0.0});
  const auto drawing = samples.draw(0, 100, 400);
  EXPECT_LE(drawing.curves[0].size(), 802);
  EXPECT_EQ(drawing.least, -5);
  EXPECT_EQ(drawing.greatest, 9);
}

TEST(Signals, DrawEachSampleWhenZoomedIn) {
  Signals samples(1);
  for (int k = 0; k < 100'000; ++k) samples.append(k * 1e-3, {static_cast<double>(k)});
  const auto drawing = samples.draw(50, 50.1, 400);
  // 50.000 to 50.100, and a neighbour on either side, whichever way the borders round.
  EXPECT_NEAR(drawing.curves[0].size(), 103, 1);
}

TEST(SignalPlot, PicksTheTimeThatIsClickedAndDraggedTo) {
  ShownPlot s;
  s.fill();
  QSignalSpy picked(&s.plot, &SignalPlot::timePicked);
  const auto at = [&](double time) {
    return QPoint(static_cast<int>(std::lround(s.qwt->canvasMap(QwtPlot::xBottom).transform(time))), 40);
  };
  const double pixel = 20.0 / s.qwt->canvas()->width();  // [s]
  QTest::mousePress(s.qwt->canvas(), Qt::LeftButton, {}, at(5));
  ASSERT_EQ(picked.size(), 1);
  EXPECT_NEAR(picked[0][0].toDouble(), 5, pixel);
  QMouseEvent drag(QEvent::MouseMove, at(12), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(s.qwt->canvas(), &drag);
  ASSERT_EQ(picked.size(), 2);
  EXPECT_NEAR(picked[1][0].toDouble(), 12, pixel);
}

TEST(SignalPlot, ZoomsAboutThePointerAndShowsAllOnADoubleClick) {
  ShownPlot s;
  s.fill();
  const QPoint pointer(s.qwt->canvas()->width() / 4, 40);
  const double before = s.qwt->canvasMap(QwtPlot::xBottom).invTransform(pointer.x());
  s.wheel(pointer, 240);
  const auto [from, to] = s.plot.timeRange();
  EXPECT_NEAR(to - from, 20 * 0.8 * 0.8, 1e-9);
  EXPECT_NEAR(s.qwt->canvasMap(QwtPlot::xBottom).invTransform(pointer.x()), before, 20.0 / s.qwt->canvas()->width());
  QTest::mouseDClick(s.qwt->canvas(), Qt::LeftButton, {}, pointer);
  EXPECT_NEAR(s.plot.timeRange().first, 0, 1e-9);
  EXPECT_NEAR(s.plot.timeRange().second, 20, 1e-9);
}

TEST(SignalPlot, KeepsTheZoomWhenMoreOfTheCurvesComes) {
  ShownPlot s;
  s.fill();
  s.wheel({100, 40}, 600);
  const auto range = s.plot.timeRange();
  s.fill();
  EXPECT_EQ(s.plot.timeRange(), range);
}

TEST(SignalPlot, RollsAndDoesNotMoveItsCanvasWhileItRolls) {
  ShownPlot s;
  QRect canvas;
  for (int k = 0; k < 3'000; ++k) {
    s.plot.append(k / 60.0, {5 + std::sin(k * 0.1), 5.0});
    if (k % 100 == 99) {
      QTest::qWait(5);
      if (k > 100) {
        EXPECT_EQ(s.qwt->canvas()->geometry(), canvas) << "after " << k / 60.0 << " s";
      }
      canvas = s.qwt->canvas()->geometry();
    }
  }
  EXPECT_NEAR(s.plot.timeRange().second, 2'999 / 60.0, 1e-9);
  EXPECT_NEAR(s.plot.timeRange().first, 2'999 / 60.0 - SignalPlot::kWindow, 1e-9);
}

TEST(SignalPlot, DoesNotTakeTheMouseWhileItRolls) {
  ShownPlot s;
  s.plot.append(0, {1, 2});
  QSignalSpy picked(&s.plot, &SignalPlot::timePicked);
  QTest::mousePress(s.qwt->canvas(), Qt::LeftButton, {}, {100, 40});
  EXPECT_EQ(picked.size(), 0);
}

TEST(SignalPlot, SaysThatItIsEmptyUntilThereIsSomething) {
  ShownPlot s;
  s.plot.setEmptyText("start a session");
  QLabel* empty = nullptr;
  for (QLabel* label : s.plot.findChildren<QLabel*>()) {
    if (label->text() == "start a session") empty = label;
  }
  ASSERT_TRUE(empty);
  EXPECT_TRUE(empty->isVisible());
  s.fill();
  EXPECT_FALSE(empty->isVisible());
  s.plot.clear();
  QTest::qWait(50);
  EXPECT_TRUE(empty->isVisible());
}

}  // namespace
}  // namespace haptiv
