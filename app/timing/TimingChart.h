#pragma once

#include <QWidget>

#include "device/realtime/TimeHistogram.h"

namespace haptiv {

/// How late the servo wakes and how long its ticks take, as two outlines over a logarithmic axis of time, counts
/// logarithmic too: one late tick in a million is seen. A line stands at the period: what lies right of it has cost
/// ticks. Thread: GUI.
class TimingChart : public QWidget {
 public:
  explicit TimingChart(QWidget* parent = nullptr);

  static QColor wakeUpColour() { return {0x00, 0x72, 0xb2}; }
  static QColor tickColour() { return {0xd5, 0x5e, 0x00}; }

  /// @param period  [ns]; 0: there is none to show
  void show(const TimeDistribution& wakeUps, const TimeDistribution& ticks, double period);

  QSize sizeHint() const override { return {360, 160}; }
  QSize minimumSizeHint() const override { return {200, 90}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QRectF canvas() const;
  double xOf(double time) const;
  double yOf(double count) const;
  void paintAxes(QPainter& painter) const;
  void paintOutline(QPainter& painter, const TimeDistribution& times, const QColor& colour) const;

  TimeDistribution wakeUps_, ticks_;
  double period_ = 0;
};

}  // namespace haptiv
