#pragma once

#include <QWidget>

#include "device/types.h"

namespace haptiv {

/// The joints' rates as bars, each from zero in the middle to the joint's limit at either end, with both numbers
/// [rad/s]. A bar turns amber near the limit and red at it. Thread: GUI.
class RateBars : public QWidget {
 public:
  static constexpr double kNear = 0.8;  ///< of the limit

  explicit RateBars(QWidget* parent = nullptr);

  /// The arm's joints, of which the vector's first `count` are there, and their limits [rad/s].
  void setJoints(int count, const JointVector& limits);
  int jointCount() const { return count_; }
  void show(const JointVector& rates);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Columns;
  Columns columns() const;
  int rowHeight() const;
  void paintRow(QPainter& painter, const Columns& columns, int joint) const;

  int count_ = 0;
  JointVector limits_ = JointVector::Ones();
  JointVector rates_ = JointVector::Zero();
};

}  // namespace haptiv
