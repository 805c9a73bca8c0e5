#include "tests/architecture/Rooms.h"

#include <gmock/gmock.h>

// No two folders include each other, not even by way of others: whoever reads one needs to read only what lies below
// it.

namespace haptiv::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<Found> includesOfAll() {
  std::vector<Found> all;
  for (const char* layer : {"device", "haptics", "scenegraph", "app"}) {
    const std::vector<Found> some = includesBelow(layer);
    EXPECT_FALSE(some.empty()) << layer << " holds no sources: has it moved?";
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

/// The includes that tie a circle, a line each.
std::string linesOf(const RoomsOfFolder& rooms, const std::set<std::string>& circle) {
  std::string lines;
  for (const std::string& from : circle) {
    for (const auto& [to, includes] : rooms.at(from)) {
      if (!circle.contains(to)) continue;
      for (const Found& each : includes)
        lines += "\n  " + each.file + ":" + std::to_string(each.line) + " includes " + each.text;
    }
  }
  return lines;
}

}  // namespace

TEST(Rooms, OfAFolderIncludeEachOtherInOneDirectionOnly) {
  for (const auto& [folder, rooms] : foldersOf(includesOfAll())) {
    const std::set<std::string> circle = circleOf(rooms);
    EXPECT_THAT(circle, IsEmpty()) << "in " << (folder.empty() ? "the whole tree" : folder) << linesOf(rooms, circle);
  }
}

TEST(Rooms, InACircleAreFound) {
  const auto folders = foldersOf({{"a/b/X.h", 1, "a/c/Y.h"},
                                  {"a/c/Y.h", 1, "a/d/deep/Z.h"},
                                  {"a/d/Z.h", 1, "a/b/X.h"},
                                  {"a/d/Z.h", 2, "vector"},
                                  {"a/above/U.h", 1, "a/b/X.h"},
                                  {"a/d/Z.h", 3, "a/below/V.h"}});
  EXPECT_THAT(circleOf(folders.at("a")), ElementsAre("b", "c", "d"));
}

TEST(Rooms, ThatIncludeTheFilesAboveThemAreInACircleWhenThoseIncludeThem) {
  const auto words = foldersOf({{"a/room/X.h", 1, "a/Word.h"}});
  EXPECT_THAT(circleOf(words.at("a")), IsEmpty());
  const auto both = foldersOf({{"a/room/X.h", 1, "a/Word.h"}, {"a/Face.h", 1, "a/room/X.h"}});
  EXPECT_THAT(circleOf(both.at("a")), ElementsAre("its own files", "room"));
}

}  // namespace haptiv::testing
