#include "app/session/log/reading/SessionLogReader.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/session/log/contents/LogLayout.h"
#include "app/session/log/reading/LoggedScenes.h"

namespace haptiv {
namespace {

using hdf5::Cell;
using hdf5::Table;
using namespace log_layout;

constexpr std::uint64_t kMostEvents = 10'000'000;  // of a hostile file; a real log stays far below
constexpr std::uint64_t kFirstFormat = 1;

}  // namespace

SessionLog::File::File(const std::filesystem::path& where) : path(where) {
  bool closedWell = false;
  file = hdf5::openFile(path, closedWell);
  expectFormat();
  readHeader();
  if (closedWell) readEnd();
  scenes = readLoggedScenes(file, path, complete);
  readEvents();
  openTicks();
  if (!complete) dropTicksWithoutScene();
}

void SessionLog::File::expectFormat() {
  const hdf5::Attributes root(file, path, "/");
  if (H5Aexists(file.id(), "format") <= 0 || root.text("format") != kFormat)
    hdf5::fail(path, "is an HDF5 file, but no session log of Haptiv", "Choose a log that `haptiv run --log` wrote");
  formatVersion = root.integer("format_version");
  if (formatVersion > kFormatVersion)
    hdf5::fail(path,
               "was written by a newer Haptiv (log format " + std::to_string(formatVersion) +
                   ", known here: " + std::to_string(kFormatVersion) + ")",
               "Install a newer Haptiv");
}

std::string SessionLog::File::readText(const char* name) const {
  const Table table = Table::open(file, path, name, Cell::uint8, 1);
  if (table.rows() > kLongestText) hdf5::fail(path, std::string(name) + " is too long for a text", kDamaged);
  std::string text(table.rows(), '\0');
  table.read(0, text.size(), text.data());
  return text;
}

void SessionLog::File::readHeader() {
  const hdf5::Attributes root(file, path, "/");
  header.softwareVersion = root.text("software_version");
  header.gitHash = root.text("git_hash");
  header.startUtc = root.text("start_utc");
  header.scheduling = root.text("scheduling");
  if (formatVersion > kFirstFormat) header.fault = root.text("fault");
  header.seed = root.integer("seed");
  header.rate = root.number("rate_hz");
  if (!std::isfinite(header.rate) || header.rate <= 0) hdf5::fail(path, "rate_hz is no positive number", kDamaged);
  header.deviceText = readText(kDeviceText);
  header.sceneName = readText(kSceneName);
  header.sceneText = readText(kSceneText);
}

void SessionLog::File::readEnd() {
  const Table completeTable = Table::open(file, path, kComplete, Cell::int64, 1);
  const Table droppedTable = Table::open(file, path, kDropped, Cell::int64, 1);
  std::int64_t completeCell = 0, droppedCell = 0;
  if (completeTable.rows() > 0) completeTable.read(0, 1, &completeCell);
  if (droppedTable.rows() > 0) droppedTable.read(0, 1, &droppedCell);
  complete = completeCell == 1;
  dropped = static_cast<std::uint64_t>(std::max<std::int64_t>(droppedCell, 0));
}

void SessionLog::File::readEvents() {
  if (formatVersion == kFirstFormat) return;
  const Table table = Table::open(file, path, kEvents, Cell::int64, kEventColumns);
  if (table.rows() > kMostEvents) hdf5::fail(path, "the log claims too many events", kDamaged);
  std::vector<std::int64_t> cells(table.rows() * kEventColumns);
  table.read(0, table.rows(), cells.data());
  for (const std::int64_t* row = cells.data(); row != cells.data() + cells.size(); row += kEventColumns) {
    if (row[2] < 0 || row[2] > static_cast<std::int64_t>(SessionEvent::Kind::trip))
      hdf5::fail(path, "an event of the log is of no known kind", kDamaged);
    events.push_back({static_cast<std::uint64_t>(row[0]), row[1], static_cast<SessionEvent::Kind>(row[2]), row[3]});
  }
}

TickGroup SessionLog::File::stored(const TickGroup& group) const {
  const std::string name = kServo + group.name;
  TickGroup found{group.name, group.frame, group.cell, {}};
  if (formatVersion == kFirstFormat && H5Lexists(file.id(), name.c_str(), H5P_DEFAULT) <= 0) return found;
  for (const std::string& each : hdf5::Attributes(file, path, name).texts("columns")) {
    const auto known = std::find_if(group.columns.begin(), group.columns.end(),
                                    [&](const TickColumn& column) { return column.name == each; });
    if (known == group.columns.end()) hdf5::fail(path, name + " has other columns than a session log", kDamaged);
    found.columns.push_back(*known);
  }
  const auto same = [](const TickColumn& a, const TickColumn& b) { return a.name == b.name; };
  std::vector<TickColumn> due = group.columns;
  std::erase_if(due, [&](const TickColumn& column) { return column.since > formatVersion; });
  if (formatVersion > kFirstFormat &&
      !std::equal(found.columns.begin(), found.columns.end(), due.begin(), due.end(), same))
    hdf5::fail(path, name + " has other columns than a session log", kDamaged);
  return found;
}

void SessionLog::File::openTicks() {
  for (const TickGroup& group : tickGroups()) {
    const TickGroup found = stored(group);
    if (found.columns.empty()) continue;
    tables.push_back(Table::open(file, path, kServo + group.name, group.cell, found.columns.size()));
    groups.push_back(found);
  }
  if (tables.empty()) hdf5::fail(path, "there are no ticks in the log", kDamaged);
  const auto [shortest, longest] = std::minmax_element(
      tables.begin(), tables.end(), [](const Table& a, const Table& b) { return a.rows() < b.rows(); });
  tickCount = shortest->rows();
  complete = complete && shortest->rows() == longest->rows();
}

void SessionLog::File::dropTicksWithoutScene() {
  while (tickCount > 0) {
    if (scenes.empty()) {
      tickCount = 0;
      return;
    }
    const std::uint64_t first = tickCount - std::min(tickCount, kBlock);
    for (const std::vector<TickRecord> ticks = read(first, tickCount - first); tickCount > first; --tickCount)
      if (ticks[tickCount - 1 - first].sceneVersion <= scenes.back().scene.version) return;
  }
}

std::vector<TickRecord> SessionLog::File::read(std::uint64_t first, std::uint64_t count) const {
  if (first >= tickCount) return {};
  std::vector<TickRecord> ticks(std::min(count, tickCount - first));
  std::vector<std::byte> rows;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    rows.resize(ticks.size() * groups[i].rowSize());
    tables[i].read(first, ticks.size(), rows.data());
    const std::byte* cell = rows.data();
    for (TickRecord& tick : ticks)
      for (const TickColumn& column : groups[i].columns) {
        column.load(tick, cell);
        cell += hdf5::sizeOf(groups[i].cell);
      }
  }
  if (formatVersion == kFirstFormat)  // in which a session ran or was in a fault
    for (TickRecord& tick : ticks) tick.state = tick.command.enabled ? SessionState::running : SessionState::fault;
  return ticks;
}

}  // namespace haptiv
