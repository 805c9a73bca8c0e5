#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "app/session/log/contents/TickColumns.h"
#include "app/session/log/hdf5/Hdf5Table.h"
#include "app/session/log/writing/SessionLogWriter.h"

namespace haptiv {

/// What of a new log is written once and for all: attributes, groups, and the texts that a session starts with.
void writeHead(const hdf5::Handle& file, const std::filesystem::path& path, const SessionHeader& header);

void writeText(hdf5::Table& table, std::string_view text);

/// The tables of a log that is being written; callers hold hdf5::Lock.
struct LogTables {
  std::vector<TickGroup> groups = tickGroups();
  std::vector<hdf5::Table> ticks;   ///< one a group
  std::vector<hdf5::Table> scenes;  ///< index, texts, bytes
  std::vector<hdf5::Table> end;     ///< complete, dropped, reason
  std::vector<hdf5::Table> events;  ///< one

  /// All that there will be: what is made later is lost in a crash.
  /// @param chunkRows  ticks that are written at once
  /// @param sceneText  how large the text of a scene is, about [bytes]
  void create(const hdf5::Handle& file, const std::filesystem::path& path, std::size_t chunkRows,
              std::size_t sceneText);
  void close();

 private:
  void createEvents(const hdf5::Handle& file, const std::filesystem::path& path);
};

}  // namespace haptiv
