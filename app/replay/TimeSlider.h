#pragma once

#include <QSlider>

namespace haptiv {

/// A slider over times, in steps of a millisecond (coarser only for logs of many days). A click goes where it points.
class TimeSlider : public QSlider {
  Q_OBJECT
 public:
  explicit TimeSlider(QWidget* parent = nullptr);

  void setDuration(double seconds);
  /// Shows this time; says nothing.
  void setTime(double seconds);

 signals:
  /// The user moved it.
  void timePicked(double seconds);

 private:
  double duration_ = 0;
};

}  // namespace haptiv
