#include "device/DeviceDescription.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <stdexcept>

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

}  // namespace

JointVector JointDrives::countsPerRadian() const {
  return gearRatio.cwiseProduct(countsPerTurn) / (2 * std::numbers::pi);
}

JointVector DeviceDescription::jointAngles(const DeviceReading& reading) const noexcept {
  const Eigen::Map<const Eigen::Matrix<std::int32_t, kJointCount, 1>> counts(reading.encoderCounts.data());
  return counts.cast<double>().cwiseQuotient(drives.countsPerRadian());
}

Wrench DeviceDescription::handleWrench(const DeviceReading& reading) const noexcept {
  const Eigen::Map<const Eigen::Matrix<std::int16_t, 6, 1>> counts(reading.sensorCounts.data());
  const Vector6 values = counts.cast<double>();
  return {sensor.forceResolution * values.head<3>(), sensor.torqueResolution * values.tail<3>()};
}

DeviceDescription loadDeviceDescription(const std::string& nameOrPath, const std::string& namedIn) {
  for (const auto& builtIn : builtInDescriptions()) {
    if (builtIn.name == nameOrPath) return parseDeviceDescription(builtIn.text, nameOrPath);
  }
  const std::string path = (std::filesystem::path(namedIn).parent_path() / nameOrPath).string();
  return parseDeviceDescription(readWhole(path), path);
}

}  // namespace haptiv
