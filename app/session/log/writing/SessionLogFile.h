#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/session/log/contents/SessionEvents.h"
#include "app/session/log/writing/LogTables.h"
#include "app/session/log/writing/SessionLogWriter.h"
#include "haptics/bytes/SceneBytes.h"

namespace haptiv {

/// The HDF5 file behind a SessionLogWriter; callers hold hdf5::Lock.
///
/// Scenes and ticks wait in memory until they are written in whole chunks, as a chunk that is written twice leaves a
/// hole in the file.
struct SessionLogWriter::File {
  File(const std::filesystem::path& path, const SessionHeader& header, FreeSpace freeSpace);

  void add(const HapticScene& scene, const std::string& text);
  void add(const TickRecord& tick);
  /// @param all  also the rows of a chunk that is not yet full
  void writeOut(bool all);
  void end(std::uint64_t dropped);
  bool isOpen() const { return static_cast<bool>(file_); }
  void expectOpen() const;

 private:
  /// Throws, and ends the log, where the disk is too full for what is waiting.
  void expectSpace();
  void writeScenes();
  void writeTicks(std::size_t rows);
  void writeEvents();
  /// Writes the end record and closes the file.
  void finish(bool complete, std::uint64_t dropped, std::string_view reason);
  /// HDF5 wants what is within a file closed before it.
  void close();

  std::filesystem::path path_;
  FreeSpace freeSpace_;
  std::size_t chunkRows_;
  hdf5::Handle file_;
  LogTables tables_;
  std::vector<std::vector<std::byte>> waitingTicks_;
  std::size_t waitingRows_ = 0;
  EventFinder findEvents_;
  std::vector<std::int64_t> waitingEvents_;
  std::vector<std::int64_t> waitingIndex_;
  std::string waitingTexts_;
  std::vector<std::byte> waitingBytes_;
  SceneEncoder encoder_;
  std::int64_t textsEnd_ = 0;
  std::int64_t bytesEnd_ = 0;
  std::int64_t newestVersion_ = -1;
};

}  // namespace haptiv
