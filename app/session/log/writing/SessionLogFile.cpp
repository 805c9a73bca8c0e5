#include "app/session/log/writing/SessionLogFile.h"

#include <algorithm>
#include <cmath>

#include "app/session/log/contents/LogLayout.h"
#include "haptics/scene/SceneNumbers.h"

namespace haptiv {
namespace {

using hdf5::Cell;
using hdf5::Table;
using namespace log_layout;

constexpr std::size_t kTextChunk = 16384;      // [bytes]
constexpr std::size_t kIndexChunk = 64;        // [rows]
constexpr std::size_t kEventChunk = 256;       // [rows]
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
      waitingTicks_(groups_.size()) {
  if (freeSpace_(path_) < kReserve) hdf5::fail(path_, "the disk is nearly full", "Make room there, or log elsewhere");
  file_ = hdf5::createFile(path_);
  createHead(header);
  createTables();
  hdf5::startSwmr(file_, path_);
  hdf5::flushToDisk(file_, path_);
}

void SessionLogWriter::File::createHead(const SessionHeader& header) {
  const hdf5::Attributes root(file_, path_, "/");
  root.write("format", std::string_view(kFormat));
  root.write("format_version", kFormatVersion);
  root.write("software_version", header.softwareVersion);
  root.write("git_hash", header.gitHash);
  root.write("seed", header.seed);
  root.write("rate_hz", header.rate);
  root.write("start_utc", header.startUtc);
  root.write("scheduling", header.scheduling);
  root.write("fault", header.fault);
  for (const char* group : {"/meta", "/meta/end", "/scenes", "/servo"}) hdf5::createGroup(file_, path_, group);
  for (const auto& [name, text] : {std::pair(kDeviceText, &header.deviceText), std::pair(kSceneName, &header.sceneName),
                                   std::pair(kSceneText, &header.sceneText)}) {
    Table table = Table::create(file_, path_, name, Cell::uint8, 1, kTextChunk);
    writeText(table, *text);
  }
}

void SessionLogWriter::File::createTables() {
  end_.push_back(Table::create(file_, path_, kComplete, Cell::int64, 1, 1));
  end_.push_back(Table::create(file_, path_, kDropped, Cell::int64, 1, 1));
  end_.push_back(Table::create(file_, path_, kReason, Cell::uint8, 1, kTextChunk));
  scenes_.push_back(Table::create(file_, path_, kSceneIndex, Cell::int64, kIndexColumns, kIndexChunk));
  scenes_.push_back(Table::create(file_, path_, kSceneTexts, Cell::uint8, 1, kTextChunk));
  scenes_.push_back(Table::create(file_, path_, kSceneBytes, Cell::uint8, 1, kTextChunk));
  createEvents();
  for (const TickGroup& group : groups_) {
    const std::string name = kServo + group.name;
    tables_.push_back(Table::create(file_, path_, name, group.cell, group.columns.size(), chunkRows_));
    std::vector<std::string> names, units;
    for (const TickColumn& column : group.columns) {
      names.push_back(column.name);
      units.push_back(column.unit);
    }
    const hdf5::Attributes attributes(file_, path_, name);
    attributes.write("columns", names);
    attributes.write("unit", units);
    attributes.write("frame", group.frame);
  }
}

void SessionLogWriter::File::createEvents() {
  events_.push_back(Table::create(file_, path_, kEvents, Cell::int64, kEventColumns, kEventChunk));
  const hdf5::Attributes attributes(file_, path_, kEvents);
  const auto names = [](SessionEvent::Kind kind, int count) {
    std::vector<std::string> all;
    for (int code = 0; code < count; ++code) all.push_back(nameOf(SessionEvent{0, 0, kind, code}));
    return all;
  };
  using enum SessionEvent::Kind;
  attributes.write("columns", std::vector<std::string>{"tick", "time_ns", "kind", "code"});
  attributes.write("kinds", std::vector<std::string>{nameOf(state), nameOf(fault), nameOf(trip)});
  attributes.write("states", names(state, kSessionStateCount));
  attributes.write("faults", names(fault, kFaultCount));
  attributes.write("trips", names(trip, kTripCount));
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
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    std::vector<std::byte>& rows = waitingTicks_[i];
    const std::size_t cellSize = hdf5::sizeOf(groups_[i].cell);
    rows.resize(rows.size() + groups_[i].rowSize());
    std::byte* cell = rows.data() + rows.size() - groups_[i].rowSize();
    for (const TickColumn& column : groups_[i].columns) {
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
  const std::uint64_t written = tables_.front().rows();
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

void SessionLogWriter::File::writeText(Table& table, std::string_view text) {
  table.append(text.data(), text.size());
}

void SessionLogWriter::File::writeScenes() {
  writeText(scenes_[1], waitingTexts_);
  scenes_[2].append(waitingBytes_.data(), waitingBytes_.size());
  scenes_[0].append(waitingIndex_.data(), waitingIndex_.size() / kIndexColumns);
  waitingTexts_.clear();
  waitingBytes_.clear();
  waitingIndex_.clear();
}

void SessionLogWriter::File::writeEvents() {
  events_.front().append(waitingEvents_.data(), waitingEvents_.size() / kEventColumns);
  waitingEvents_.clear();
}

void SessionLogWriter::File::writeTicks(std::size_t rows) {
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    tables_[i].append(waitingTicks_[i].data(), rows);
    const auto done = static_cast<std::ptrdiff_t>(rows * groups_[i].rowSize());
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
  end_[1].append(&droppedCell, 1);
  writeText(end_[2], reason);
  end_[0].append(&completeCell, 1);
  hdf5::flushToDisk(file_, path_);
  close();
}

void SessionLogWriter::File::close() {
  tables_.clear();
  scenes_.clear();
  events_.clear();
  end_.clear();
  file_.reset();
}

}  // namespace haptiv
