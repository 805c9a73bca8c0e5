#include "haptics/scene/SceneIndexer.h"

#include <limits>

#include "tests/haptics/RandomShapes.h"
#include "tests/haptics/SameIndices.h"

namespace haptiv {
namespace {

using testing::expectIndicesAsAnew;
using testing::RandomShapes;

/// A scene that is edited by chance, version after version.
class EditedScene {
 public:
  EditedScene(unsigned seed, int walls, int zones) : random_(seed) {
    for (int i = 0; i < walls; ++i) now_.walls.push_back({++ids_, anyShape(), {}});
    for (int i = 0; i < zones; ++i) now_.zones.push_back({++ids_, Zone::Kind::spring, anyShape()});
    indexer_.index(now_);
  }

  /// Few edits, or many, in one version.
  void edit(int edits) {
    HapticScene next = now_;
    for (int i = 0; i < edits; ++i) editOne(next.walls), editOne(next.zones);
    indexer_.index(next, now_, runsOf(next.walls, now_.walls), {});
    now_ = std::move(next);
  }
  const HapticScene& scene() const { return now_; }

 private:
  Shape anyShape() {
    Shape shape = random_.shape(static_cast<Shape::Kind>(number(4)), 0.2);
    shape.centre = number(10) == 0 ? Vector3(0.5, 0.5, 0.5) : random_.vector(2);  // crowds, too
    if (number(200) == 0) shape.centre *= 1e6;
    if (number(300) == 0) shape.centre[1] = std::numeric_limits<double>::quiet_NaN();
    return shape;
  }
  int number(int below) { return static_cast<int>(random_.between(0, below)); }

  template <typename Felt>
  void editOne(std::vector<Felt>& shapes) {
    const auto at = shapes.empty() ? shapes.end() : shapes.begin() + number(static_cast<int>(shapes.size()));
    const int kind = number(5);
    if (kind == 0 || shapes.empty()) {
      Felt added;
      added.id = ++ids_;
      added.shape = anyShape();
      shapes.insert(at, added);
    } else if (kind == 1) {
      shapes.erase(at);
    } else if (kind == 2) {
      at->shape = anyShape();
    } else if (kind == 3) {
      at->shape.centre += random_.vector(0.01);
    } else {
      at->shape.axes *= 0.9;
    }
  }

  /// What a compiler would know: some of what has stayed, by the ids, which rise.
  template <typename Felt>
  KeptRuns runsOf(const std::vector<Felt>& now, const std::vector<Felt>& before) {
    KeptRuns runs;
    std::uint32_t i = 0, k = 0;
    while (i < now.size() && k < before.size()) {
      const auto &a = now[i], &b = before[k];
      if (a.id == b.id && a.shape.axes == b.shape.axes && a.shape.centre == b.shape.centre &&
          a.shape.kind == b.shape.kind && number(20) > 0) {
        runs.push_back({k, i, 1});
      }
      if (a.id == b.id) {
        ++i, ++k;
      } else if (i + 1 < now.size() && now[i + 1].id == b.id) {
        ++i;
      } else {
        ++k;
      }
    }
    return runs;
  }

  RandomShapes random_;
  ShapeId ids_ = 0;
  HapticScene now_;
  SceneIndexer indexer_;
};

TEST(SceneIndexer, ComesToTheSameIndicesAsWhenEverythingIsIndexedAnew) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    EditedScene edited(seed, seed % 3 == 0 ? 5 : 700, 40);
    for (int version = 0; version < 60; ++version) {
      edited.edit(version % 10 == 9 ? 50 : 1);
      expectIndicesAsAnew(edited.scene());
      if (::testing::Test::HasFailure()) FAIL() << "seed " << seed << ", version " << version;
    }
  }
}

/// Every box on one spot: groups are cut in halves, and no cut is as before.
TEST(SceneIndexer, IndexesACrowdOnOneSpotAsAnew) {
  HapticScene now;
  for (ShapeId id = 1; id <= 300; ++id) now.walls.push_back({id, Shape(), {}});
  SceneIndexer indexer;
  indexer.index(now);
  for (int version = 0; version < 20; ++version) {
    HapticScene next = now;
    next.walls.erase(next.walls.begin() + 7 * version);
    indexer.index(next, now, {}, {});
    now = std::move(next);
    expectIndicesAsAnew(now);
  }
}

TEST(SceneIndexer, TakesAnIndexThatItHasNotMadeForNone) {
  RandomShapes random(3);
  HapticScene before;  // without indices
  for (ShapeId id = 1; id <= 20; ++id) before.walls.push_back({id, random.shape(Shape::Kind::box), {}});
  HapticScene now = before;
  now.walls[3].shape.centre *= 2;
  SceneIndexer().index(now, before, {}, {});
  expectIndicesAsAnew(now);
}

}  // namespace
}  // namespace haptiv
