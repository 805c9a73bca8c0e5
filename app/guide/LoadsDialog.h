#pragma once

#include <QDialog>
#include <vector>

#include "app/guide/WeightBox.h"
#include "device/described/DeviceDescription.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace haptiv {

/// In which the user says what will hang on the handle: a line a load, as a force and a torque, or as a weight at a
/// place; out of a file and into one, as `haptiv device calibrate --loads` takes it. What is wrong with them is told at
/// once, and wrong ones are not taken. Thread: GUI.
class LoadsDialog : public QDialog {
  Q_OBJECT
 public:
  LoadsDialog(const HandleSensor& sensor, const std::vector<Vector6>& loads, QWidget* parent = nullptr);

  /// What was entered, once the dialog was accepted.
  const std::vector<Vector6>& loads() const { return loads_; }

 private:
  QWidget* buildButtons();
  void show(const std::vector<Vector6>& loads);
  void append(const Vector6& load);
  void addLine(const Vector6& load);
  std::vector<Vector6> entered() const;
  void judge();
  void openFile();
  void saveFile();
  void tell(const QString& what, bool wrong);

  HandleSensor sensor_;
  std::vector<Vector6> loads_;
  QTableWidget* table_;
  WeightBox* weight_;
  QLabel* verdict_;
  QPushButton* take_ = nullptr;
};

}  // namespace haptiv
