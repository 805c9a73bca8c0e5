#include "app/session/log/writing/SessionLogFile.h"

#include <algorithm>
#include <cmath>

#include "app/session/log/contents/LogLayout.h"
#include "haptics/scene/SceneNumbers.h"

namespace haptiv {
namespace {

using namespace log_layout;

constexpr double kLongestChunk = 50000;        // [rows]
constexpr std::uint64_t kReserve = 16u << 20;  // [bytes] left free, enough to close the file and for others to go on

std::size_t chunkRowsFor(double rate, const std::filesystem::path& path) {
  if (!std::isfinite(rate) || rate <= 0)
    hdf5::fail(path, "the rate of the session is no positive number", "Choose one, such as 1000 Hz");
  return static_cast<std::size_t>(std::clamp(std::round(rate * kFlushInterval), 1.0, kLongestChunk));
}

}  // namespace

SessionLogWriter::File::File(const std::filesystem::path& path, const SessionHeader& header, FreeSpace freeSpace)
    : path_(path),
      freeSpace_(std::move(freeSpace)),
      chunkRows_(chunkRowsFor(header.rate, path)),
      waitingTicks_(tables_.groups.size()) {
  if (freeSpace_(path_) < kReserve) hdf5::fail(path_, "the disk is nearly full", "Make room there, or log elsewhere");
  file_ = hdf5::createFile(path_);
  writeHead(file_, path_, header);
  tables_.create(file_, path_, chunkRows_, header.sceneText.size());
  hdf5::startSwmr(file_, path_);
  hdf5::flushToDisk(file_, path_);
}

void SessionLogWriter::File::expectOpen() const {
  if (!isOpen()) hdf5::fail(path_, "the session log has been ended", "Start a new session for a new log");
}

void SessionLogWriter::File::add(const HapticScene& scene, const std::string& text) {
  if (scene.version <= newestVersion_)
    hdf5::fail(path_,
               "a scene of version " + std::to_string(scene.version) + " comes after one of version " +
                   std::to_string(newestVersion_),
               "Give every scene of a session a greater version");
  if (const std::string wrong = wrongNumberIn(scene); !wrong.empty())
    hdf5::fail(path_, "a scene in which " + wrong + " could not be read again", "Mend the scene");
  newestVersion_ = scene.version;
  const std::vector<std::byte> bytes = encoder_.encode(scene);
  const auto textSize = static_cast<std::int64_t>(text.size()), byteSize = static_cast<std::int64_t>(bytes.size());
  waitingIndex_.insert(waitingIndex_.end(), {newestVersion_, textsEnd_, textSize, bytesEnd_, byteSize});
  waitingTexts_ += text;
  waitingBytes_.insert(waitingBytes_.end(), bytes.begin(), bytes.end());
  textsEnd_ += textSize;
  bytesEnd_ += byteSize;
}

void SessionLogWriter::File::add(const TickRecord& tick) {
  for (std::size_t i = 0; i < tables_.groups.size(); ++i) {
    std::vector<std::byte>& rows = waitingTicks_[i];
    const std::size_t cellSize = hdf5::sizeOf(tables_.groups[i].cell);
    rows.resize(rows.size() + tables_.groups[i].rowSize());
    std::byte* cell = rows.data() + rows.size() - tables_.groups[i].rowSize();
    for (const TickColumn& column : tables_.groups[i].columns) {
      column.store(tick, cell);
      cell += cellSize;
    }
  }
  ++waitingRows_;
  findEvents_.take(tick, [this](const SessionEvent& event) {
    waitingEvents_.insert(waitingEvents_.end(), {static_cast<std::int64_t>(event.tick), event.time,
                                                 static_cast<std::int64_t>(event.kind), event.code});
  });
}

void SessionLogWriter::File::expectSpace() {
  std::size_t waiting = waitingTexts_.size() + waitingBytes_.size();
  for (const auto& rows : waitingTicks_) waiting += rows.size();
  if (freeSpace_(path_) >= waiting + kReserve) return;
  finish(false, 0, "disk nearly full");
  hdf5::fail(path_, "the disk is nearly full: the session log ends here, and what was written stays readable",
             "Make room there, or log elsewhere");
}

void SessionLogWriter::File::writeOut(bool all) {
  const std::uint64_t written = tables_.ticks.front().rows();
  const std::uint64_t wholeChunks = (written + waitingRows_) / chunkRows_ * chunkRows_;
  const std::size_t rows = all ? waitingRows_ : wholeChunks > written ? wholeChunks - written : 0;
  if (rows == 0 && !all) return;
  expectSpace();
  try {
    writeScenes();
    writeEvents();
    writeTicks(rows);
    hdf5::flushToDisk(file_, path_);
  } catch (...) {
    hdf5::abandon(file_);
    close();
    throw;
  }
}

void SessionLogWriter::File::writeScenes() {
  writeText(tables_.scenes[1], waitingTexts_);
  tables_.scenes[2].append(waitingBytes_.data(), waitingBytes_.size());
  tables_.scenes[0].append(waitingIndex_.data(), waitingIndex_.size() / kIndexColumns);
  waitingTexts_.clear();
  waitingBytes_.clear();
  waitingIndex_.clear();
}

void SessionLogWriter::File::writeEvents() {
  tables_.events.front().append(waitingEvents_.data(), waitingEvents_.size() / kEventColumns);
  waitingEvents_.clear();
}

void SessionLogWriter::File::writeTicks(std::size_t rows) {
  for (std::size_t i = 0; i < tables_.groups.size(); ++i) {
    tables_.ticks[i].append(waitingTicks_[i].data(), rows);
    const auto done = static_cast<std::ptrdiff_t>(rows * tables_.groups[i].rowSize());
    waitingTicks_[i].erase(waitingTicks_[i].begin(), waitingTicks_[i].begin() + done);
  }
  waitingRows_ -= rows;
}

void SessionLogWriter::File::end(std::uint64_t dropped) {
  writeOut(true);
  finish(true, dropped, "");
}

void SessionLogWriter::File::finish(bool complete, std::uint64_t dropped, std::string_view reason) {
  const std::int64_t completeCell = complete, droppedCell = static_cast<std::int64_t>(dropped);
  tables_.end[1].append(&droppedCell, 1);
  writeText(tables_.end[2], reason);
  tables_.end[0].append(&completeCell, 1);
  hdf5::flushToDisk(file_, path_);
  close();
}

void SessionLogWriter::File::close() {
  tables_.close();
  file_.reset();
}

}  // namespace haptiv
