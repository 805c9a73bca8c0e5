#pragma once

#include <string>
#include <vector>

#include "app/calibration/Calibration.h"

namespace haptiv {

/// What the operator is led through, in this order.
enum class GuideStep { pose, bias, loads, finish };

/// Leads through homing and calibration, step by step: what to do, what has been found. No window, no device.
class CalibrationGuide {
 public:
  explicit CalibrationGuide(const DeviceDescription& description, std::vector<Vector6> loads = standardLoads());

  GuideStep step() const noexcept { return step_; }
  /// In words: what the step is called, and what the operator has to do.
  std::string title() const;
  std::string instruction() const;
  /// What is to hang on the handle, one after the other; those that were measured are to be measured anew.
  const std::vector<Vector6>& loads() const noexcept { return loads_; }
  /// @param loads  at least one
  void setLoads(std::vector<Vector6> loads);
  /// What is to hang on the handle now, in T [N], [N m]; zeros where nothing is.
  Vector6 load() const;

  /// A measurement for this step: goes on, and says what was found.
  /// Throws CalibrationRefused, what and what to do; the step stays. After the last load, where the loads together are
  /// refused, they begin anew.
  /// @param anew  at the pose: any zero is plausible
  std::string take(const QuietMeasurement& measured, bool anew = false);
  /// Leaves this step out.
  void skip();
  /// The first step again; what was found stays until it is found anew.
  void restart();

  /// Whether this device has that step: one of the impedance type has no force sensor.
  bool has(GuideStep step) const noexcept;
  bool isDone(GuideStep step) const noexcept { return done_[static_cast<std::size_t>(step)]; }
  const Calibration& calibration() const noexcept { return calibration_; }
  /// What has changed, a line each; "nothing" where nothing has.
  std::string summary() const;

 private:
  std::string takePose(const QuietMeasurement& measured, bool anew);
  std::string takeBias(const QuietMeasurement& measured);
  std::string takeLoad(const QuietMeasurement& measured);
  void next();

  DeviceDescription before_;
  Calibration calibration_;
  std::vector<Vector6> loads_;
  GuideStep step_ = GuideStep::pose;
  std::array<bool, 4> done_{};
};

const char* nameOf(GuideStep step);
/// "+10 N of force x", of a load along one axis; all six numbers of any other.
std::string loadInWords(const Vector6& load);

}  // namespace haptiv
