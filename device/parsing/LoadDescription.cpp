#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "device/described/DeviceDescription.h"
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

}  // namespace

DeviceDescription loadDeviceDescription(const std::string& nameOrPath, const std::string& namedIn) {
  for (const auto& builtIn : builtInDescriptions()) {
    if (builtIn.name == nameOrPath) return parseDeviceDescription(builtIn.text, nameOrPath);
  }
  const std::string path = (std::filesystem::path(namedIn).parent_path() / nameOrPath).string();
  if (!namedIn.empty()) requireWithinFolderOf(namedIn, path);
  return parseDeviceDescription(readWhole(path), path);
}

}  // namespace haptiv
