#include "app/session/recording/FlightRecorder.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "app/session/log/writing/SessionLogWriter.h"
#include "app/session/recording/UtcTime.h"

namespace haptiv {
namespace {

/// "device trip: watchdog" as it stands in a file's name: "device-trip-watchdog".
std::string slugOf(const std::string& name) {
  std::string slug;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      slug += c;
    } else if (!slug.empty() && slug.back() != '-') {
      slug += '-';
    }
  }
  return slug;
}

}  // namespace

FlightRecorder::FlightRecorder(SessionHeader header, std::filesystem::path folder, std::string stem)
    : header_(std::move(header)),
      folder_(std::move(folder)),
      stem_(std::move(stem)),
      capacity_(static_cast<std::size_t>(std::max(1.0, std::round(kLength * header_.rate)))) {}

void FlightRecorder::addScene(std::shared_ptr<const HapticScene> scene, SharedText text) {
  scenes_.push_back({std::move(scene), std::move(text)});
}

void FlightRecorder::take(const TickRecord& record) {
  if (ticks_.size() < capacity_) {
    ticks_.push_back(record);
  } else {
    ticks_[next_] = record;
    next_ = (next_ + 1) % capacity_;
  }
  forgetScenes();
  const bool fresh = record.state == SessionState::fault && state_ != SessionState::fault;
  state_ = record.state;
  if (fresh) write(faultList(record.faults));
}

/// The scenes before the one that the oldest tick felt.
void FlightRecorder::forgetScenes() {
  const std::uint32_t oldest = ticks_[ticks_.size() < capacity_ ? 0 : next_].sceneVersion;
  while (scenes_.size() > 1 && scenes_.front().scene->version < oldest) scenes_.erase(scenes_.begin());
}

void FlightRecorder::write(const std::string& fault) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error)
    throw std::runtime_error(folder_.string() + ": cannot make this folder for what led to a fault: " +
                             error.message() + ". Give the session a log in a folder that exists");
  SessionHeader header = header_;
  header.fault = fault;
  const std::filesystem::path path = freshPath(fault);
  SessionLogWriter writer(path, header);
  for (const Scene& each : scenes_) writer.addScene(*each.scene, each.text.get());
  std::rotate(ticks_.begin(), ticks_.begin() + static_cast<std::ptrdiff_t>(next_), ticks_.end());
  next_ = 0;
  writer.append(ticks_);
  writer.close(0);
  files_.push_back(path);
}

std::filesystem::path FlightRecorder::freshPath(const std::string& fault) const {
  std::string time = utcNow();
  std::replace(time.begin(), time.end(), ':', '-');
  const std::string first = stem_ + "-fault-" + time + "-" + slugOf(fault.substr(0, fault.find(',')));
  std::filesystem::path path = folder_ / (first + ".h5");
  for (int n = 2; std::filesystem::exists(path); ++n) path = folder_ / (first + "-" + std::to_string(n) + ".h5");
  return path;
}

std::filesystem::path flightFolder() {
  const auto set = [](const char* variable) {
    const char* value = std::getenv(variable);
    return std::filesystem::path(value != nullptr ? value : "");
  };
  if (const std::filesystem::path state = set("XDG_STATE_HOME"); state.is_absolute()) return state / "haptiv";
  if (const std::filesystem::path home = set("HOME"); home.is_absolute()) return home / ".local/state/haptiv";
  return std::filesystem::temp_directory_path() / "haptiv";
}

}  // namespace haptiv
