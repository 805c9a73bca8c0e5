#include "app/session/log/writing/LogTables.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "app/session/log/contents/LogLayout.h"
#include "app/session/log/contents/SessionEvents.h"

namespace haptiv {
namespace {

using hdf5::Cell;
using hdf5::Table;
using namespace log_layout;

constexpr std::size_t kTextChunk = 16384;  // [bytes]
constexpr std::size_t kIndexChunk = 64;    // [rows]
constexpr std::size_t kEventChunk = 256;   // [rows]

/// HDF5 keeps some 250 bytes in memory for each chunk, as long as the file is open: of large scenes there are to be
/// few. What a chunk that is not full loses when it is written again must stay small beside the scene.
std::size_t sceneChunk(std::size_t sceneText) {
  constexpr std::size_t kMost = 1 << 20;
  return std::bit_floor(std::clamp(sceneText / 2, kTextChunk, kMost));
}

}  // namespace

void writeText(Table& table, std::string_view text) {
  table.append(text.data(), text.size());
}

void writeHead(const hdf5::Handle& file, const std::filesystem::path& path, const SessionHeader& header) {
  const hdf5::Attributes root(file, path, "/");
  root.write("format", std::string_view(kFormat));
  root.write("format_version", kFormatVersion);
  root.write("software_version", header.softwareVersion);
  root.write("git_hash", header.gitHash);
  root.write("seed", header.seed);
  root.write("rate_hz", header.rate);
  root.write("start_utc", header.startUtc);
  root.write("scheduling", header.scheduling);
  root.write("fault", header.fault);
  for (const char* group : {"/meta", "/meta/end", "/scenes", "/servo"}) hdf5::createGroup(file, path, group);
  for (const auto& [name, text] : {std::pair(kDeviceText, &header.deviceText), std::pair(kSceneName, &header.sceneName),
                                   std::pair(kSceneText, &header.sceneText)}) {
    Table table = Table::create(file, path, name, Cell::uint8, 1, kTextChunk);
    writeText(table, *text);
  }
}

void LogTables::create(const hdf5::Handle& file, const std::filesystem::path& path, std::size_t chunkRows,
                       std::size_t sceneText) {
  end.push_back(Table::create(file, path, kComplete, Cell::int64, 1, 1));
  end.push_back(Table::create(file, path, kDropped, Cell::int64, 1, 1));
  end.push_back(Table::create(file, path, kReason, Cell::uint8, 1, kTextChunk));
  scenes.push_back(Table::create(file, path, kSceneIndex, Cell::int64, kIndexColumns, kIndexChunk));
  scenes.push_back(Table::create(file, path, kSceneTexts, Cell::uint8, 1, sceneChunk(sceneText)));
  scenes.push_back(Table::create(file, path, kSceneBytes, Cell::uint8, 1, sceneChunk(sceneText)));
  createEvents(file, path);
  for (const TickGroup& group : groups) {
    const std::string name = kServo + group.name;
    ticks.push_back(Table::create(file, path, name, group.cell, group.columns.size(), chunkRows));
    std::vector<std::string> names, units;
    for (const TickColumn& column : group.columns) {
      names.push_back(column.name);
      units.push_back(column.unit);
    }
    const hdf5::Attributes attributes(file, path, name);
    attributes.write("columns", names);
    attributes.write("unit", units);
    attributes.write("frame", group.frame);
  }
}

void LogTables::createEvents(const hdf5::Handle& file, const std::filesystem::path& path) {
  events.push_back(Table::create(file, path, kEvents, Cell::int64, kEventColumns, kEventChunk));
  const hdf5::Attributes attributes(file, path, kEvents);
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

void LogTables::close() {
  ticks.clear();
  scenes.clear();
  events.clear();
  end.clear();
}

}  // namespace haptiv
