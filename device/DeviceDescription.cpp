#include "device/DeviceDescription.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "device/Encoder.h"
#include "device/descriptions/BuiltInDescriptions.h"

namespace haptiv {

namespace {

std::string builtInNames() {
  std::string names;
  for (const auto& builtIn : builtInDescriptions()) names += (names.empty() ? "" : ", ") + std::string(builtIn.name);
  return names;
}

constexpr std::uintmax_t kLargestFile = 1 << 20;  // [bytes]

std::string readWhole(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw std::runtime_error(
        path + ": no such device description; give the path of a TOML file, or a built-in name: " + builtInNames());
  }
  if (std::filesystem::file_size(path, error) > kLargestFile)
    throw std::runtime_error(path + ": larger than 1 MB, which no device description is; name another file");
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file.good() && !file.eof()) throw std::runtime_error(path + ": cannot be read; check its permissions");
  return text;
}

/// A scene of somebody else's is not to have its user's files read.
void requireWithinFolderOf(const std::string& scene, const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(scene).parent_path(), error);
  const fs::path target = fs::weakly_canonical(fs::absolute(path), error);
  if (error || std::mismatch(folder.begin(), folder.end(), target.begin(), target.end()).first != folder.end())
    throw std::runtime_error(path + ": is outside of the folder of the scene that names it, " + scene +
                             "; copy it there, or use a built-in name: " + builtInNames());
}

Vector6 perAxis(double force, double torque) {
  Vector6 values;
  values << Vector3::Constant(force), Vector3::Constant(torque);
  return values;
}

}  // namespace

JointVector JointDrives::countsPerRadian() const {
  return gearRatio.cwiseProduct(countsPerTurn) / (2 * std::numbers::pi);
}

JointVector DeviceDescription::jointAngles(const DeviceReading& reading) const noexcept {
  const Eigen::Map<const Eigen::Matrix<std::int32_t, kJointCount, 1>> counts(reading.encoderCounts.data());
  return (counts.cast<double>() - encoders.zero).cwiseQuotient(drives.countsPerRadian());
}

PoseCounts DeviceDescription::countsAt(const JointVector& angles) const noexcept {
  const JointVector perRadian = drives.countsPerRadian();
  PoseCounts counts{};
  for (int i = 0; i < kJointCount; ++i)
    counts[static_cast<std::size_t>(i)] = Encoder(perRadian[i], encoders.zero[i]).count(angles[i]);
  return counts;
}

Vector6 HandleSensor::raw(const std::array<std::int16_t, 6>& counts) const noexcept {
  const Eigen::Map<const Eigen::Matrix<std::int16_t, 6, 1>> values(counts.data());
  return resolution().cwiseProduct(values.cast<double>());
}

Vector6 HandleSensor::resolution() const noexcept {
  return perAxis(forceResolution, torqueResolution);
}

Vector6 HandleSensor::range() const noexcept {
  return perAxis(forceRange, torqueRange);
}

std::array<std::int16_t, 6> HandleSensor::lastCounts() const noexcept {
  constexpr double kMost = std::numeric_limits<std::int16_t>::max();
  std::array<std::int16_t, 6> last{};
  for (int i = 0; i < 6; ++i)
    last[static_cast<std::size_t>(i)] =
        static_cast<std::int16_t>(std::min(std::floor(range()[i] / resolution()[i]), kMost));
  return last;
}

Wrench DeviceDescription::handleWrench(const DeviceReading& reading) const noexcept {
  const Vector6 wrench = sensor.matrix * (sensor.raw(reading.sensorCounts) - sensor.bias);
  return {wrench.head<3>(), wrench.tail<3>()};
}

DeviceDescription loadDeviceDescription(const std::string& nameOrPath, const std::string& namedIn) {
  for (const auto& builtIn : builtInDescriptions()) {
    if (builtIn.name == nameOrPath) return parseDeviceDescription(builtIn.text, nameOrPath);
  }
  const std::string path = (std::filesystem::path(namedIn).parent_path() / nameOrPath).string();
  if (!namedIn.empty()) requireWithinFolderOf(namedIn, path);
  return parseDeviceDescription(readWhole(path), path);
}

}  // namespace haptiv
