#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/session/log/contents/SessionEvents.h"
#include "app/session/log/contents/SessionHeader.h"
#include "haptics/scene/HapticScene.h"
#include "haptics/tick/TickRecord.h"

namespace haptiv {

/// A scene that was in force during a session.
struct LoggedScene {
  HapticScene scene;
  std::string text;
};

/// Reads a session log, also one that was cut off. Files may be hostile: the constructor throws std::runtime_error
/// that says what is wrong with which part of the file.
class SessionLog {
 public:
  explicit SessionLog(const std::filesystem::path& path);
  ~SessionLog();
  SessionLog(SessionLog&&) noexcept;
  SessionLog& operator=(SessionLog&&) noexcept;

  const SessionHeader& header() const;
  bool complete() const;  ///< false: cut off before its end
  std::uint64_t tickCount() const;
  std::uint64_t dropped() const;                   ///< ticks that never reached the log
  const std::vector<LoggedScene>& scenes() const;  ///< by version, ascending
  /// In order; those of ticks that never reached the log can be among them. A log of format 1 has none.
  const std::vector<SessionEvent>& events() const;
  std::uint64_t formatVersion() const;

  static constexpr std::uint64_t kBlock = 4096;  ///< [ticks] good to hold in memory at a time

  /// Ticks [first, first + count), fewer at the end. All fields of the record are there, the inputs and the results
  /// bit for bit.
  std::vector<TickRecord> ticks(std::uint64_t first, std::uint64_t count) const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace haptiv
