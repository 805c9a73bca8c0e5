#pragma once

#include <QGroupBox>
#include <array>

#include "app/calibration/HungWeight.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace haptiv {

/// The fields for a weight that hangs on the handle: its mass, where gravity pulls, where it hangs. Thread: GUI.
class WeightBox : public QGroupBox {
  Q_OBJECT
 public:
  explicit WeightBox(QWidget* parent = nullptr);

 signals:
  void added(const haptiv::HungWeight& weight);

 private:
  HungWeight weight() const;
  void showLoad();
  QDoubleSpinBox* number(const char* name, double low, double high, int decimals, double step);

  QDoubleSpinBox* mass_;
  QComboBox* down_;
  std::array<QDoubleSpinBox*, 3> place_;
  QLabel* load_;
};

}  // namespace haptiv
