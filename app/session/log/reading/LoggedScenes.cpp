#include "app/session/log/reading/LoggedScenes.h"

#include <stdexcept>

#include "app/session/log/contents/LogLayout.h"
#include "app/session/log/hdf5/Hdf5Table.h"
#include "haptics/bytes/SceneBytes.h"

namespace haptiv {
namespace {

using hdf5::Cell;
using hdf5::Table;
using namespace log_layout;

constexpr std::uint64_t kMostScenes = 1'000'000;

/// One row of /scenes/index.
struct SceneRow {
  std::int64_t version, text, textSize, bytes, byteSize;
};
static_assert(sizeof(SceneRow) == kIndexColumns * sizeof(std::int64_t));

/// Whether [offset, offset + size) follows on `end` and lies within the table.
bool follows(std::int64_t offset, std::int64_t size, std::int64_t end, const Table& table) {
  return offset == end && size >= 0 && static_cast<std::uint64_t>(size) <= kLongestText &&
         static_cast<std::uint64_t>(offset) + static_cast<std::uint64_t>(size) <= table.rows();
}

}  // namespace

std::vector<LoggedScene> readLoggedScenes(const hdf5::Handle& file, const std::filesystem::path& path, bool complete) {
  std::vector<LoggedScene> scenes;
  const Table index = Table::open(file, path, kSceneIndex, Cell::int64, kIndexColumns);
  const Table texts = Table::open(file, path, kSceneTexts, Cell::uint8, 1);
  const Table bytes = Table::open(file, path, kSceneBytes, Cell::uint8, 1);
  if (index.rows() > kMostScenes) hdf5::fail(path, "the log claims too many scenes", kDamaged);
  std::vector<SceneRow> rows(index.rows());
  index.read(0, rows.size(), rows.data());
  SceneRow last{-1, 0, 0, 0, 0};
  SceneDecoder decoder;
  for (const SceneRow& row : rows) {
    if (row.version <= last.version || !follows(row.text, row.textSize, last.text + last.textSize, texts) ||
        !follows(row.bytes, row.byteSize, last.bytes + last.byteSize, bytes)) {
      if (!complete) return scenes;  // this one was being written when the log was cut off
      hdf5::fail(path, "the list of scenes contradicts itself after version " + std::to_string(last.version), kDamaged);
    }
    LoggedScene scene;
    scene.text.resize(static_cast<std::size_t>(row.textSize));
    std::vector<std::byte> packed(static_cast<std::size_t>(row.byteSize));
    texts.read(static_cast<std::uint64_t>(row.text), scene.text.size(), scene.text.data());
    bytes.read(static_cast<std::uint64_t>(row.bytes), packed.size(), packed.data());
    try {
      scene.scene = decoder.decode(packed);
    } catch (const std::runtime_error& error) {
      hdf5::fail(path, "scene version " + std::to_string(row.version) + ": " + error.what(), kDamaged);
    }
    if (scene.scene.version != row.version)
      hdf5::fail(path, "the scene listed as version " + std::to_string(row.version) + " is another one", kDamaged);
    scenes.push_back(std::move(scene));
    last = row;
  }
  return scenes;
}

}  // namespace haptiv
