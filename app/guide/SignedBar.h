#pragma once

#include <QWidget>

namespace haptiv {

/// A bar from the middle to the right for positive values, to the left for negative ones. Thread: GUI.
class SignedBar : public QWidget {
 public:
  explicit SignedBar(QWidget* parent = nullptr);
  /// @param share  -1 to 1; more is shown as the end
  void setShare(double share);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double share_ = 0;
};

}  // namespace haptiv
