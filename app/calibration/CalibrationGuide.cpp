#include "app/calibration/CalibrationGuide.h"

#include <cmath>
#include <cstdio>
#include <utility>

#include "device/calibration/CalibrationRefused.h"
#include "device/calibration/QuietCheck.h"

namespace haptiv {
namespace {

std::string text(const char* format, double number) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, number);
  return buffer.data();
}

std::string list(const Vector6& v, int from, const char* format) {
  return text(format, v[from]) + "  " + text(format, v[from + 1]) + "  " + text(format, v[from + 2]);
}

std::string inWords(const Vector6& wrench) {
  return "force " + list(wrench, 0, "%.2f") + " N, torque " + list(wrench, 3, "%.3f") + " N m";
}

}  // namespace

std::string loadInWords(const Vector6& load) {
  Eigen::Index axis = 0;
  const double most = load.cwiseAbs().maxCoeff(&axis);
  if (load.cwiseAbs().sum() != most) return inWords(load);
  return text("%+.3g", load[axis]) + (axis < 3 ? " N of " : " N m of ") + nameOfAxis(static_cast<int>(axis));
}

const char* nameOf(GuideStep step) {
  constexpr std::array kNames = {"Reference pose", "Sensor bias", "Sensor matrix", "Save"};
  return kNames[static_cast<std::size_t>(step)];
}

CalibrationGuide::CalibrationGuide(const DeviceDescription& description, std::vector<Vector6> loads)
    : before_(description), calibration_(description), loads_(std::move(loads)) {}

std::string CalibrationGuide::title() const {
  if (step_ != GuideStep::loads) return nameOf(step_);
  return std::string(nameOf(step_)) + ": load " + std::to_string(calibration_.loads() + 1) + " of " +
         std::to_string(loads_.size());
}

std::string CalibrationGuide::instruction() const {
  switch (step_) {
    case GuideStep::pose:
      return "Set the arm by hand into its reference pose, as marked on its joints, and let go. The brakes hold it. "
             "What the encoders count there tells where each joint's zero is.";
    case GuideStep::bias:
      return "Take the hand off the handle and leave it alone. What the sensor says now is its bias.";
    case GuideStep::loads:
      return "Hang " + loadInWords(load()) + " on the handle, in the handle's axes, and let it hang still.";
    case GuideStep::finish:
      return "Save the device description with what was found. Its comments and everything else stay as they are.";
  }
  return {};
}

void CalibrationGuide::setLoads(std::vector<Vector6> loads) {
  calibration_.forgetLoads();
  loads_ = std::move(loads);
}

Vector6 CalibrationGuide::load() const {
  return step_ == GuideStep::loads ? loads_[calibration_.loads()] : Vector6(Vector6::Zero());
}

void CalibrationGuide::next() {
  done_[static_cast<std::size_t>(step_)] = true;
  skip();
}

void CalibrationGuide::skip() {
  calibration_.forgetLoads();
  if (step_ == GuideStep::finish) return;
  do step_ = static_cast<GuideStep>(static_cast<int>(step_) + 1);
  while (!has(step_));
}

bool CalibrationGuide::has(GuideStep step) const noexcept {
  return before_.type != DeviceType::impedance || (step != GuideStep::bias && step != GuideStep::loads);
}

void CalibrationGuide::restart() {
  calibration_.forgetLoads();
  step_ = GuideStep::pose;
}

std::string CalibrationGuide::take(const QuietMeasurement& measured, bool anew) {
  switch (step_) {
    case GuideStep::pose:
      return takePose(measured, anew);
    case GuideStep::bias:
      return takeBias(measured);
    case GuideStep::loads:
      return takeLoad(measured);
    case GuideStep::finish:
      break;
  }
  return {};
}

std::string CalibrationGuide::takePose(const QuietMeasurement& measured, bool anew) {
  const FoundZero found = calibration_.takeZero(measured, anew);
  next();
  Eigen::Index joint = 0;
  const double most = found.change.cwiseAbs().maxCoeff(&joint);
  return "The zeros are found. The largest change: " + text("%.4f", most) + " rad at joint " +
         std::to_string(joint + 1) + ".";
}

std::string CalibrationGuide::takeBias(const QuietMeasurement& measured) {
  const SensorBias found = calibration_.takeBias(measured);
  next();
  return "The bias is found: " + inWords(found.bias) + ".";
}

std::string CalibrationGuide::takeLoad(const QuietMeasurement& measured) {
  calibration_.takeLoad(load(), measured);
  if (calibration_.loads() < loads_.size()) return "Load " + std::to_string(calibration_.loads()) + " is measured.";
  try {
    const SensorMatrix found = calibration_.takeMatrix();
    next();
    return "The matrix is found. Condition " + text("%.2f", found.condition) + "; it leaves up to " +
           text("%.2g", found.residual.head<3>().maxCoeff()) + " N and " +
           text("%.2g", found.residual.tail<3>().maxCoeff()) + " N m unexplained.";
  } catch (const CalibrationRefused&) {
    calibration_.forgetLoads();
    throw;
  }
}

std::string CalibrationGuide::summary() const {
  const DeviceDescription& now = calibration_.description();
  std::string all;
  if (isDone(GuideStep::pose)) {
    const JointVector change = (now.encoders.zero - before_.encoders.zero).cwiseQuotient(now.drives.countsPerRadian());
    all += "Encoders: zeros moved by up to " + text("%.4f", change.cwiseAbs().maxCoeff()) + " rad\n";
  }
  if (isDone(GuideStep::bias)) all += "Sensor: bias " + inWords(now.sensor.bias) + "\n";
  if (isDone(GuideStep::loads))
    all += "Sensor: matrix, up to " +
           text("%.1f", 100 * (now.sensor.matrix - Matrix6::Identity()).diagonal().cwiseAbs().maxCoeff()) +
           " % off unity on its diagonal\n";
  return all.empty() ? "Nothing was measured." : all;
}

}  // namespace haptiv
