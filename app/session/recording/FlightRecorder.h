#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/session/log/contents/SessionHeader.h"
#include "app/session/recording/SharedText.h"
#include "haptics/scene/HapticScene.h"
#include "haptics/tick/TickRecord.h"

namespace haptiv {

/// Keeps the newest ticks of a session, and writes them to a file of their own when the session goes into a fault:
/// what led to it is then there even where no log is written, or the log's disk is full.
///
/// The file is a session log (docs/session-log.md) that starts in the middle and names the fault in its header:
/// STEM-fault-2006-01-02T15-04-05Z-tracking-error.h5, never in place of another one. Thread: the log writer's.
class FlightRecorder {
 public:
  static constexpr double kLength = 2;  ///< [s]

  /// @param header  of the session's log
  /// @param folder  where the files go; made where it is missing, once there is a fault
  /// @param stem    how their names begin
  FlightRecorder(SessionHeader header, std::filesystem::path folder, std::string stem);

  /// A scene that ticks with its version are going to name.
  void addScene(std::shared_ptr<const HapticScene> scene, SharedText text);
  /// The next tick. Throws std::runtime_error, file and what to do named, where a fault cannot be written.
  void take(const TickRecord& record);
  /// What has been written so far.
  const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  struct Scene {
    std::shared_ptr<const HapticScene> scene;
    SharedText text;
  };

  void write(const std::string& fault);
  std::filesystem::path freshPath(const std::string& fault) const;
  void forgetScenes();

  SessionHeader header_;
  std::filesystem::path folder_;
  std::string stem_;
  std::vector<TickRecord> ticks_;  // a ring: the oldest stands at next_ once it is full
  std::size_t capacity_;
  std::size_t next_ = 0;
  std::vector<Scene> scenes_;
  SessionState state_ = SessionState::idle;
  std::vector<std::filesystem::path> files_;
};

/// Where faults of sessions without a log are kept: $XDG_STATE_HOME/haptiv, or ~/.local/state/haptiv, or, where there
/// is no home, the folder for temporary files.
std::filesystem::path flightFolder();

}  // namespace haptiv
