#pragma once

#include <filesystem>
#include <vector>

#include "app/session/log/contents/TickColumns.h"
#include "app/session/log/hdf5/Hdf5Table.h"
#include "app/session/log/reading/SessionLog.h"

namespace haptiv {

/// The open HDF5 file behind a SessionLog; callers hold hdf5::Lock.
struct SessionLog::File {
  /// Reads all but the ticks. Throws as SessionLog's constructor does.
  explicit File(const std::filesystem::path& path);

  std::vector<TickRecord> read(std::uint64_t first, std::uint64_t count) const;

  std::filesystem::path path;
  hdf5::Handle file;
  bool complete = false;
  SessionHeader header;
  std::vector<LoggedScene> scenes;
  std::vector<SessionEvent> events;
  std::uint64_t formatVersion = 0;
  std::uint64_t tickCount = 0;
  std::uint64_t dropped = 0;
  std::vector<TickGroup> groups;    // as they stand in this file
  std::vector<hdf5::Table> tables;  // one a group

 private:
  void expectFormat();
  void readHeader();
  void readEnd();
  void readEvents();
  void openTicks();
  /// The columns of `group` that the file has; of an older format, not all of them.
  TickGroup stored(const TickGroup& group) const;
  /// After a crash, ticks can be there whose scene is not.
  void dropTicksWithoutScene();
  std::string readText(const char* name) const;
};

}  // namespace haptiv
