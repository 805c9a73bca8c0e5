#pragma once

#include <QDialog>
#include <functional>
#include <memory>

#include "app/calibration/BrakedDevice.h"
#include "app/calibration/CalibrationGuide.h"

namespace haptiv {

/// Opens the device that is to be calibrated; throws std::runtime_error, what and what to do.
using DeviceOpener = std::function<BrakedDevice(const DeviceDescription& description)>;

/// The dialog that leads through homing and calibration, with live readings. The device's arm is braked all the while.
/// What was found ends in a file, where the user says so. Thread: GUI.
class CalibrationDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param source  name or path that the description came from
  CalibrationDialog(const DeviceDescription& description, const QString& source, const DeviceOpener& open,
                    QWidget* parent = nullptr);
  ~CalibrationDialog() override;

  /// How long a measurement takes [s].
  void setMeasuringTime(double seconds);

 signals:
  /// The description has been written.
  void saved(const QString& path);

 private:
  void build();
  void makeWords();
  void makeControls();
  void arrange();
  void connectParts();
  void openDevice(const DeviceOpener& open);
  void catchUp();
  void tick();
  void startMeasuring();
  void finishMeasuring();
  void showStep();
  void showSteps();
  void tell(const QString& what, bool refused);
  void chooseLoads();
  void save();

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
