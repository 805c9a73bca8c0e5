#pragma once

#include <QDoubleSpinBox>

namespace haptiv {

/// A number with its unit. Reports a value only when it is meant: on a step, on Enter, on leaving.
class NumberField : public QDoubleSpinBox {
  Q_OBJECT
 public:
  /// How a number is shown, in the shown unit.
  struct Format {
    QString suffix;
    double minimum = 0;
    double maximum = 1e6;
    double step = 1;
    int decimals = 2;
  };
  explicit NumberField(const Format& format, QWidget* parent = nullptr);

  /// Shows a value without reporting it, whatever the scene has: one outside of the format's range, or with more
  /// decimals than it, is shown as it is.
  void show(double value);
  using QDoubleSpinBox::show;

 protected:
  QString textFromValue(double value) const override;
  bool event(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  Format format_;
};

}  // namespace haptiv
