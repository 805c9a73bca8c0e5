#include "tests/architecture/Rooms.h"

namespace haptiv::testing {
namespace {

std::string folderOf(const std::string& path) {
  const auto slash = path.rfind('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

/// The part of a path that follows on a folder's: a room; the folder's own files are "its own files".
std::string roomIn(const std::string& folder, const std::string& path) {
  const std::string rest = folder.empty() ? path : path.substr(folder.size() + 1);
  const auto slash = rest.find('/');
  return slash == std::string::npos ? "its own files" : rest.substr(0, slash);
}

bool isBelow(const std::string& folder, const std::string& path) {
  return folder.empty() || path.starts_with(folder + "/");
}

/// All that a room includes, by itself or by way of others.
std::set<std::string> reachedFrom(const std::string& room, const RoomsOfFolder& rooms) {
  std::set<std::string> reached;
  std::vector<std::string> waiting = {room};
  while (!waiting.empty()) {
    const auto next = rooms.find(waiting.back());
    waiting.pop_back();
    if (next == rooms.end()) continue;
    for (const auto& included : next->second) {
      if (reached.insert(included.first).second) waiting.push_back(included.first);
    }
  }
  return reached;
}

}  // namespace

std::map<std::string, RoomsOfFolder> foldersOf(const std::vector<Found>& includes) {
  std::set<std::string> layers;
  for (const Found& include : includes) layers.insert(roomIn("", include.file));
  std::map<std::string, RoomsOfFolder> folders;
  for (const Found& include : includes) {
    if (!layers.contains(roomIn("", include.text))) continue;
    for (std::string folder = folderOf(include.file);; folder = folderOf(folder)) {
      if (isBelow(folder, include.text)) {
        const std::string from = roomIn(folder, include.file), to = roomIn(folder, include.text);
        RoomsOfFolder& rooms = folders[folder];
        if (from != to) rooms[from][to].push_back(include);
      }
      if (folder.empty()) break;
    }
  }
  return folders;
}

std::set<std::string> circleOf(const RoomsOfFolder& rooms) {
  std::set<std::string> circle;
  for (const auto& room : rooms) {
    if (reachedFrom(room.first, rooms).contains(room.first)) circle.insert(room.first);
  }
  return circle;
}

}  // namespace haptiv::testing
