#include "app/dexterity/RateBars.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/dexterity/DexterityColours.h"

namespace haptiv {
namespace {

constexpr int kGap = 6;  // [pixels] between columns
constexpr int kShortestBar = 60;
constexpr int kRateHeight = 9;

/// Without the sign of a rate that is rounded to zero.
QString numberOf(double rate) {
  return QString::number(std::abs(rate) < 0.005 ? 0 : rate, 'f', 2);
}

QColor colourOfRate(double share) {
  if (share >= 1) return DexterityColours::bad();
  return share >= RateBars::kNear ? DexterityColours::near() : DexterityColours::good();
}

}  // namespace

struct RateBars::Columns {
  QRect joint, bar, rate, limit;  // of the heading's row
};

RateBars::RateBars(QWidget* parent) : QWidget(parent) {
  setObjectName("rateBars");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setToolTip(tr("Rates that the joints are sent, against the limits of the device description"));
}

void RateBars::setJoints(int count, const JointVector& limits) {
  count_ = std::clamp(count, 0, kJointCount);
  limits_ = limits;
  updateGeometry();
  update();
}

void RateBars::show(const JointVector& rates) {
  if (rates_ == rates) return;
  rates_ = rates;
  update();
}

int RateBars::rowHeight() const {
  return fontMetrics().height() + 2;
}

QSize RateBars::sizeHint() const {
  return {columns().bar.left() + 2 * kShortestBar + columns().rate.width() + columns().limit.width() + 2 * kGap,
          (count_ + 1) * rowHeight()};
}

QSize RateBars::minimumSizeHint() const {
  return sizeHint() - QSize(kShortestBar, 0);
}

RateBars::Columns RateBars::columns() const {
  const int height = rowHeight();
  const int joint = fontMetrics().horizontalAdvance(tr("Joint"));
  const int rate = fontMetrics().horizontalAdvance("-00.00");
  const int limit = std::max(fontMetrics().horizontalAdvance("00.00"), fontMetrics().horizontalAdvance(tr("limit")));
  Columns columns;
  columns.joint = {0, 0, joint, height};
  columns.limit = {width() - limit, 0, limit, height};
  columns.rate = {columns.limit.left() - kGap - rate, 0, rate, height};
  const int left = joint + kGap;
  columns.bar = {left, 0, std::max(columns.rate.left() - kGap - left, 0), height};
  return columns;
}

void RateBars::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Columns heading = columns();
  painter.setPen(DexterityColours::faint());
  painter.drawText(heading.joint, Qt::AlignLeft | Qt::AlignVCenter, tr("Joint"));
  painter.drawText(heading.rate, Qt::AlignRight | Qt::AlignVCenter, tr("rate"));
  painter.drawText(heading.limit, Qt::AlignRight | Qt::AlignVCenter, tr("limit"));
  for (int joint = 0; joint < count_; ++joint) paintRow(painter, heading, joint);
}

void RateBars::paintRow(QPainter& painter, const Columns& heading, int joint) const {
  const int down = (joint + 1) * rowHeight();
  const double limit = limits_[joint];
  const double share = limit > 0 ? rates_[joint] / limit : 0;
  const QColor colour = colourOfRate(std::abs(share));

  const QRect row = heading.bar.translated(0, down);
  const QRect track(row.left(), row.center().y() - kRateHeight / 2, row.width(), kRateHeight);
  painter.fillRect(track, DexterityColours::track());
  const int middle = track.center().x();
  const int length = static_cast<int>(std::lround(std::clamp(share, -1.0, 1.0) * (track.width() / 2)));
  painter.fillRect(QRect(length < 0 ? middle + length : middle, track.top(), std::abs(length), track.height()), colour);
  painter.fillRect(QRect(middle, track.top() - 1, 1, track.height() + 2), DexterityColours::mark());

  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(heading.joint.translated(0, down), Qt::AlignRight | Qt::AlignVCenter, QString::number(joint + 1));
  if (colour != DexterityColours::good()) painter.setPen(colour);
  painter.drawText(heading.rate.translated(0, down), Qt::AlignRight | Qt::AlignVCenter, numberOf(rates_[joint]));
  painter.setPen(DexterityColours::faint());
  painter.drawText(heading.limit.translated(0, down), Qt::AlignRight | Qt::AlignVCenter,
                   QString::number(limit, 'f', 2));
}

}  // namespace haptiv
