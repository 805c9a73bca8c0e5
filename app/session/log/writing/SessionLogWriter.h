#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "app/session/log/contents/SessionHeader.h"
#include "haptics/scene/HapticScene.h"
#include "haptics/tick/TickRecord.h"

namespace haptiv {

/// Bytes that may still be written to the disk that holds a file.
std::uint64_t freeSpaceFor(const std::filesystem::path& file);

/// Writes a session to an HDF5 file that survives kill -9, power cuts and full disks up to the last flush.
/// Layout: LogLayout.h.
///
/// Every call may throw std::runtime_error that names the file and says what to do. A disk that is nearly full ends
/// the log early: the call that finds it so throws, and what was written stays readable. Thread: any one.
class SessionLogWriter {
 public:
  using FreeSpace = std::function<std::uint64_t(const std::filesystem::path&)>;

  /// Overwrites the file if there is one.
  SessionLogWriter(const std::filesystem::path& path, const SessionHeader& header, FreeSpace freeSpace = freeSpaceFor);
  ~SessionLogWriter();  ///< closes without end record if close was not called: the log counts as cut off
  SessionLogWriter(const SessionLogWriter&) = delete;
  SessionLogWriter& operator=(const SessionLogWriter&) = delete;

  /// A scene that ticks with this version are going to name, greater than the versions before; text as in the header.
  void addScene(const HapticScene& scene, const std::string& text);
  /// Brings the ticks of every full half second to the disk.
  void append(std::span<const TickRecord> ticks);
  /// Brings everything to the disk.
  void flush();
  /// Ends the log as complete. `dropped`: ticks that never reached the log.
  void close(std::uint64_t dropped);

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace haptiv
