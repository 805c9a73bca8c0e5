#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/calibration/QuietMeasurement.h"
#include "device/calibration/ReferencePose.h"
#include "device/calibration/SensorBias.h"
#include "device/calibration/SensorMatrix.h"

namespace haptiv {

/// A description that becomes that of the device at hand: what is measured, step by step, changes it. The same steps
/// for window and command line. Each step throws CalibrationRefused where its measurement is no good; nothing has
/// changed then.
class Calibration {
 public:
  explicit Calibration(const DeviceDescription& description) : description_(description) {}

  const DeviceDescription& description() const noexcept { return description_; }
  bool isChanged() const noexcept { return changed_; }

  /// The handle was untouched meanwhile.
  SensorBias takeBias(const QuietMeasurement& measured);
  /// This load hung on the handle meanwhile.
  void takeLoad(const Vector6& load, const QuietMeasurement& measured);
  /// A load of which the readings are known already: sensor counts, as means.
  void takeLoad(const Vector6& load, const Vector6& counts);
  std::size_t loads() const noexcept { return loads_.size(); }
  void forgetLoads() noexcept { loads_.clear(); }
  /// From the loads so far, less the bias.
  SensorMatrix takeMatrix();
  /// The arm stood in the reference pose meanwhile.
  /// @param anew  no zero was known, or power was lost: any change is plausible
  FoundZero takeZero(const QuietMeasurement& measured, bool anew);

  /// The description's text with what has been found; see calibratedText.
  std::string text(const std::string& sourceName) const;

 private:
  DeviceDescription description_;
  std::vector<LoadCase> loads_;
  bool changed_ = false;
};

/// Both ways along each axis of the sensor: 10 N, 0.4 N m, which the brakes of the arm hold.
std::vector<Vector6> standardLoads();

}  // namespace haptiv
