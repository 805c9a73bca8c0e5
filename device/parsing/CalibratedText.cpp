#include "device/parsing/CalibratedText.h"

#include <array>
#include <charconv>
#include <span>
#include <vector>

#include "device/parsing/KeyEdit.h"

namespace haptiv {
namespace {

/// In so many digits at most, and no more than needed.
std::string text(double number, int digits) {
  std::array<char, 40> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), number, std::chars_format::general, digits);
  double rounded = 0;
  std::from_chars(buffer.data(), end.ptr, rounded);
  const auto shortest = std::to_chars(buffer.data(), buffer.data() + buffer.size(), rounded + 0.0);  // no -0
  return {buffer.data(), shortest.ptr};
}

template <typename Values>
std::string list(const Values& values, Eigen::Index count, int digits) {
  std::string all;
  for (Eigen::Index i = 0; i < count; ++i) all += (i == 0 ? "" : ", ") + text(values[i], digits);
  return "[" + all + "]";
}

constexpr int kBiasDigits = 6, kMatrixDigits = 7;  // far below the sensor's noise
constexpr int kExact = 17;                         // whole counts, and angles that are compared

std::string rows(const Matrix6& matrix) {
  std::string all;
  for (int i = 0; i < 6; ++i) {
    const Vector6 row = matrix.row(i);
    all += "\n  " + list(row, 6, kMatrixDigits) + ",";
  }
  return "[" + all + "\n]";
}

}  // namespace

std::string calibratedText(const DeviceDescription& calibrated, const std::string& sourceName) {
  const DeviceDescription before = parseDeviceDescription(calibrated.text, sourceName);
  const Eigen::Index joints = calibrated.jointCount();
  std::vector<KeyValue> changes;
  if (calibrated.sensor.matrix != before.sensor.matrix)
    changes.push_back({"sensor", "matrix", rows(calibrated.sensor.matrix)});
  if (calibrated.sensor.bias != before.sensor.bias)
    changes.push_back({"sensor", "bias", list(calibrated.sensor.bias, 6, kBiasDigits)});
  if (calibrated.encoders.reference != before.encoders.reference)
    changes.push_back({"encoders", "reference", list(calibrated.encoders.reference, joints, kExact)});
  if (calibrated.encoders.zero != before.encoders.zero)
    changes.push_back({"encoders", "zero", list(calibrated.encoders.zero, joints, kExact)});
  const std::string text = withKeys(calibrated.text, changes, sourceName);
  parseDeviceDescription(text, sourceName);  // throws where nobody could load it
  return text;
}

}  // namespace haptiv
