#pragma once

#include <QWidget>
#include <array>

#include "app/guide/SignedBar.h"
#include "device/described/DeviceDescription.h"

class QLabel;

namespace haptiv {

/// What a device says now, as its description understands it: the handle's sensor, axis by axis, and how far each joint
/// is from the reference pose. Thread: GUI.
class LiveReadings : public QWidget {
  Q_OBJECT
 public:
  explicit LiveReadings(QWidget* parent = nullptr);
  void show(const DeviceDescription& description, const DeviceReading& reading);

 private:
  std::array<QLabel*, 6> axes_{};
  std::array<SignedBar*, 6> bars_{};
  std::array<QLabel*, kJointCount> angles_{}, offsets_{};
};

}  // namespace haptiv
