#include "device/usb/falcon/FalconFirmware.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace haptiv::falcon {
namespace {

constexpr std::uintmax_t kSmallest = 1024, kLargest = 256 * 1024;  // [bytes]

const char* const kWhatToDo =
    "; give the firmware file of the Falcon's own driver package, see docs/falcon.md: by --firmware FILE, or in the "
    "window by Session > Device > Falcon's firmware";

bool isText(const std::vector<std::uint8_t>& bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](std::uint8_t byte) {
    return byte >= 32 ? byte != 127 : byte == '\n' || byte == '\r' || byte == '\t';
  });
}

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::filesystem::path keptPath() {
  const std::string home = environment("XDG_DATA_HOME");
  return (home.empty() ? environment("HOME") + "/.local/share" : home) + "/haptiv/falcon.bin";
}

}  // namespace

std::vector<std::uint8_t> readFirmware(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw std::runtime_error(path + ": no such firmware file" + kWhatToDo);
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size < kSmallest || size > kLargest)
    throw std::runtime_error(path + ": of " + std::to_string(error ? 0 : size) +
                             " bytes, and a Falcon's firmware has 1 kB to 256 kB" + kWhatToDo);
  std::ifstream file(path, std::ios::binary);
  std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
  if (bytes.size() != size) throw std::runtime_error(path + ": cannot be read; check its permissions");
  if (isText(bytes)) throw std::runtime_error(path + ": is text, and no firmware" + kWhatToDo);
  return bytes;
}

std::string keepFirmware(const std::string& path) {
  const std::vector<std::uint8_t> bytes = readFirmware(path);
  const std::filesystem::path place = keptPath(), beside = place.string() + ".new";
  std::error_code error;
  std::filesystem::create_directories(place.parent_path(), error);  // whether it could, the file tells
  std::ofstream file(beside, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file) std::filesystem::rename(beside, place, error);
  if (!file || error)
    throw std::runtime_error(place.string() + ": the firmware file cannot be kept there; check permissions and space");
  return place;
}

std::string firmwarePath() {
  const std::string named = environment("HAPTIV_FALCON_FIRMWARE");
  return named.empty() ? keptPath().string() : named;
}

}  // namespace haptiv::falcon
