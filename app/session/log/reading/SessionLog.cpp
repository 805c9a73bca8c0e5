#include "app/session/log/reading/SessionLog.h"

#include <array>
#include <chrono>
#include <fstream>

#include "app/session/log/reading/LogProbe.h"
#include "app/session/log/reading/SessionLogReader.h"

namespace haptiv {
namespace {

constexpr std::chrono::seconds kPatience(10);

/// Cheap checks that tell the commonest mistakes in plain words.
void expectHdf5(const std::filesystem::path& path) {
  constexpr std::array<char, 8> kSignature{'\x89', 'H', 'D', 'F', '\r', '\n', '\x1a', '\n'};
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    hdf5::fail(path, "there is no such file", "Give the path of a log that `haptiv run --log` wrote");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) hdf5::fail(path, "the file cannot be read", "Ask its owner for permission");
  std::array<char, 8> start{};
  stream.read(start.data(), start.size());
  if (start != kSignature)
    hdf5::fail(path, "is not an HDF5 file, so no session log", "Choose a log that `haptiv run --log` wrote");
}

}  // namespace

SessionLog::SessionLog(const std::filesystem::path& path) {
  expectHdf5(path);
  const hdf5::Lock lock;
  const auto probe = [&path] {
    const File file(path);
    if (file.tickCount == 0) return;
    file.read(0, 1);
    file.read(file.tickCount - 1, 1);
  };
  probeInChild(path, probe, kPatience);
  file_ = std::make_unique<File>(path);
}

SessionLog::~SessionLog() {
  const hdf5::Lock lock;
  file_.reset();
}

SessionLog::SessionLog(SessionLog&&) noexcept = default;

SessionLog& SessionLog::operator=(SessionLog&& other) noexcept {
  const hdf5::Lock lock;
  file_ = std::move(other.file_);
  return *this;
}

const SessionHeader& SessionLog::header() const {
  return file_->header;
}

bool SessionLog::complete() const {
  return file_->complete;
}

std::uint64_t SessionLog::tickCount() const {
  return file_->tickCount;
}

std::uint64_t SessionLog::dropped() const {
  return file_->dropped;
}

const std::vector<LoggedScene>& SessionLog::scenes() const {
  return file_->scenes;
}

const std::vector<SessionEvent>& SessionLog::events() const {
  return file_->events;
}

std::uint64_t SessionLog::formatVersion() const {
  return file_->formatVersion;
}

std::vector<TickRecord> SessionLog::ticks(std::uint64_t first, std::uint64_t count) const {
  const hdf5::Lock lock;
  return file_->read(first, count);
}

}  // namespace haptiv
