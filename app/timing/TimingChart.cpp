#include "app/timing/TimingChart.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/timing/DurationText.h"

namespace haptiv {
namespace {

constexpr double kFirst = 100, kLast = 1e8;  // [ns]
constexpr double kTopPower = 6;              // of the axis of counts
constexpr int kMargin = 4;                   // [pixels]
const QColor kGrid(0xe3, 0xe6, 0xe9);
const QColor kInk(0x55, 0x5b, 0x61);
const QColor kPeriod(0xb0, 0x00, 0x20);

}  // namespace

TimingChart::TimingChart(QWidget* parent) : QWidget(parent) {
  setObjectName("timingChart");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setToolTip(
      tr("How many ticks of this session woke so late and took so long; the red line is the time between ticks"));
}

void TimingChart::show(const TimeDistribution& wakeUps, const TimeDistribution& ticks, double period) {
  wakeUps_ = wakeUps;
  ticks_ = ticks;
  period_ = period;
  update();
}

QRectF TimingChart::canvas() const {
  const int letters = fontMetrics().height();
  const int half = fontMetrics().horizontalAdvance("100 ms") / 2;
  return QRectF(rect()).adjusted(fontMetrics().horizontalAdvance("1M") + 2 * kMargin, kMargin, -kMargin - half,
                                 -letters - kMargin);
}

double TimingChart::xOf(double time) const {
  const double share = std::log(std::clamp(time, kFirst, kLast) / kFirst) / std::log(kLast / kFirst);
  return canvas().left() + share * canvas().width();
}

/// One count stands a little above the axis, none on it.
double TimingChart::yOf(double count) const {
  const double share = count >= 1 ? (0.5 + std::log10(count)) / (0.5 + kTopPower) : 0;
  return canvas().bottom() - std::min(share, 1.0) * canvas().height();
}

void TimingChart::paintAxes(QPainter& painter) const {
  const QRectF area = canvas();
  const int letters = fontMetrics().height();
  painter.fillRect(area, Qt::white);
  for (double time = kFirst; time <= kLast * 1.001; time *= 10) {
    const double x = xOf(time);
    painter.setPen(kGrid);
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.setPen(kInk);
    if (std::lround(std::log10(time)) % 3 == 0 || area.width() > 420)
      painter.drawText(QRectF(x - 40, area.bottom() + 1, 80, letters), Qt::AlignCenter,
                       QString::fromStdString(durationText(time)));
  }
  for (int power = 0; power <= static_cast<int>(kTopPower); power += 2) {
    const double y = yOf(std::pow(10, power));
    painter.setPen(kGrid);
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setPen(kInk);
    const QString count =
        power == 6 ? "1M" : QString::number(std::lround(std::pow(10, power % 3))) + (power > 3 ? "k" : "");
    painter.drawText(QRectF(0, y - letters / 2.0, area.left() - kMargin, letters), Qt::AlignRight | Qt::AlignVCenter,
                     count);
  }
}

void TimingChart::paintOutline(QPainter& painter, const TimeDistribution& times, const QColor& colour) const {
  QPolygonF outline;
  outline << QPointF(canvas().left(), canvas().bottom());
  for (std::size_t bin = TimeHistogram::binOf(static_cast<std::int64_t>(kFirst)); bin < times.counts.size(); ++bin) {
    const double y = yOf(static_cast<double>(times.counts[bin]));
    outline << QPointF(xOf(static_cast<double>(TimeHistogram::beginOf(bin))), y)
            << QPointF(xOf(static_cast<double>(TimeHistogram::beginOf(bin + 1))), y);
  }
  outline << QPointF(canvas().right(), canvas().bottom());
  QColor fill = colour;
  fill.setAlpha(60);
  painter.setPen(QPen(colour, 1.5));
  painter.setBrush(fill);
  painter.drawPolygon(outline);
}

void TimingChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintAxes(painter);
  paintOutline(painter, wakeUps_, wakeUpColour());
  paintOutline(painter, ticks_, tickColour());
  if (!(period_ > 0)) return;
  painter.setPen(QPen(kPeriod, 1.5));
  painter.drawLine(QPointF(xOf(period_), canvas().top()), QPointF(xOf(period_), canvas().bottom()));
}

}  // namespace haptiv
