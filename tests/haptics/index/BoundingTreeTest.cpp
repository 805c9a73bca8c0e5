#include "haptics/index/BoundingTree.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

#include "tests/haptics/index/RandomBoxes.h"

namespace haptiv {
namespace {

using test::Random;
using testing::distanceOf;
using testing::gapOf;
using testing::near;
using testing::randomBoxes;
using testing::sorted;

/// Single precision, seen from the tree's middle: what is visited is no farther away than this beyond the reach.
constexpr double kRounding = 1e-6;

struct Place {
  double size;  ///< of the scene [m]
  Vector3 centre;
};

/// Scenes of a millimetre to kilometres, at the origin and far from it.
class BoundingTreeAt : public ::testing::TestWithParam<Place> {
 protected:
  template <typename Check>
  void forRandomTrees(Check&& check) {
    const auto [size, centre] = GetParam();
    Random random(7);
    for (const std::size_t count : {1, 2, 3, 4, 5, 17, 64, 300, 2000}) {
      const std::vector<Bounds> boxes = randomBoxes(random, count, size, centre);
      check(random, boxes, BoundingTree(boxes));
    }
  }
  Vector3 anywhere(Random& random) const {
    return GetParam().centre + random.vector<Vector3>(-1.2 * GetParam().size, 1.2 * GetParam().size);
  }
};

TEST_P(BoundingTreeAt, FindsWhatAFlatScanFinds) {
  const double size = GetParam().size;
  forRandomTrees([&](Random& random, const std::vector<Bounds>& boxes, const BoundingTree& tree) {
    for (int query = 0; query < 100; ++query) {
      const Vector3 p = anywhere(random);
      const double reach = size * std::pow(10, random.between(-4, 0.5));
      const std::vector<std::uint32_t> found = sorted(near(tree, p, reach));
      EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << "visited twice";
      for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        const bool isFound = std::binary_search(found.begin(), found.end(), i);
        EXPECT_TRUE(isFound || gapOf(boxes[i], p) > reach);
        EXPECT_TRUE(!isFound || gapOf(boxes[i], p) <= reach + kRounding * size);
      }
    }
  });
}

TEST_P(BoundingTreeAt, ListsWhatItVisitsWithinAReachOrNothing) {
  const double size = GetParam().size;
  int listed = 0, refused = 0;
  forRandomTrees([&](Random& random, const std::vector<Bounds>&, const BoundingTree& tree) {
    for (int query = 0; query < 100; ++query) {
      const Vector3 p = anywhere(random);
      const double reach = size * std::pow(10, random.between(-4, 0.5));
      std::vector<std::uint32_t> visited;
      tree.forEachWithin(p, reach, [&](std::uint32_t item) { visited.push_back(item); });
      std::array<std::uint32_t, 100> items;
      std::vector<std::uint32_t> told;
      const auto count = tree.listWithin({p, p}, reach, items, [&](std::uint32_t item) { told.push_back(item); });
      ++(count ? listed : refused);
      if (!count) {
        EXPECT_GT(tree.size(), 60u);
        continue;
      }
      EXPECT_EQ(told, std::vector<std::uint32_t>(items.begin(), items.begin() + *count));
      EXPECT_EQ(sorted(told), sorted(visited));
    }
  });
  EXPECT_GT(listed, 500);
  EXPECT_GT(refused, 0);
}

TEST_P(BoundingTreeAt, ListsWhatIsNearABoxAndTheSameOfItsNodesAlone) {
  const double size = GetParam().size;
  int near = 0;
  forRandomTrees([&](Random& random, const std::vector<Bounds>& boxes, const BoundingTree& tree) {
    std::vector<std::uint32_t> nodes(tree.nodes().size());
    std::iota(nodes.begin(), nodes.end(), 0U);
    for (int query = 0; query < 100; ++query) {
      const Vector3 p = anywhere(random), half = size * std::pow(10, random.between(-3, -0.5)) * Vector3(1, 0.5, 0.1);
      const Bounds from{p - half, p + half};
      const double reach = size * std::pow(10, random.between(-4, -0.5));
      std::array<std::uint32_t, 3000> items, again;
      const auto count = tree.listWithin(from, reach, items, [](std::uint32_t) {});
      if (!count) continue;
      ASSERT_EQ(tree.listOf(nodes, from, reach, again), count);
      const std::vector<std::uint32_t> listed = sorted({items.begin(), items.begin() + *count});
      EXPECT_EQ(listed, sorted({again.begin(), again.begin() + *count}));
      for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        const double distance = (boxes[i].low - from.high).cwiseMax(from.low - boxes[i].high).cwiseMax(0).norm();
        const bool isListed = std::binary_search(listed.begin(), listed.end(), i);
        EXPECT_TRUE(isListed || distance > reach);
        EXPECT_TRUE(!isListed || distance <= reach + 2 * kRounding * size);
        near += isListed ? 1 : 0;
      }
    }
  });
  EXPECT_GT(near, 300);
}

TEST_P(BoundingTreeAt, MissesNothingOnABallsWay) {
  const double size = GetParam().size;
  forRandomTrees([&](Random& random, const std::vector<Bounds>& boxes, const BoundingTree& tree) {
    for (int query = 0; query < 50; ++query) {
      const Vector3 from = anywhere(random);
      const Vector3 to = query % 2 == 0 ? anywhere(random) : Vector3(from + 0.01 * (anywhere(random) - from));
      const double reach = size * std::pow(10, random.between(-3, -1));
      std::vector<char> found(boxes.size(), 0);
      tree.forEachAlong(from, to, reach, [&](std::uint32_t item) { ++found[item]; });
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_LE(found[i], 1);
        for (double t = 0; t <= 1; t += 1.0 / 64) {
          ASSERT_TRUE(found[i] || distanceOf(boxes[i], from + t * (to - from)) > reach);
        }
      }
    }
  });
}

TEST_P(BoundingTreeAt, FindsTheNearestWithoutMeasuringMuch) {
  constexpr std::size_t kQueries = 50;
  const double size = GetParam().size;
  forRandomTrees([&](Random& random, const std::vector<Bounds>& boxes, const BoundingTree& tree) {
    std::size_t measured = 0;
    for (std::size_t query = 0; query < kQueries; ++query) {
      const Vector3 p = anywhere(random);
      const double reach = query % 2 == 0 ? INFINITY : 0.1 * size;
      double expected = reach;
      for (const Bounds& box : boxes) expected = std::min(expected, distanceOf(box, p));
      EXPECT_EQ(tree.nearest(p, reach,
                             [&](std::uint32_t item) {
                               ++measured;
                               return distanceOf(boxes[item], p);
                             }),
                expected);
    }
    EXPECT_LT(measured, kQueries * (50 + boxes.size() / 10));
  });
}

INSTANTIATE_TEST_SUITE_P(Scenes, BoundingTreeAt,
                         ::testing::Values(Place{1, {0, 0, 0}}, Place{0.001, {0, 0, 0}}, Place{1000, {0, 0, 0}},
                                           Place{1, {5000, -7000, 1e6}}, Place{0.001, {1, 1, -10}},
                                           Place{1000, {1e7, 0, 0}}));

TEST(BoundingTree, VisitsOnlyTheBoxesThatALongThinWayCrosses) {
  std::vector<Bounds> boxes;  // 100 x 100 posts on the plane
  for (int i = 0; i < 10000; ++i) {
    const Vector3 middle(i % 100, i / 100, 0);
    boxes.push_back({middle.array() - 0.1, middle.array() + 0.1});
  }
  std::size_t visited = 0;
  BoundingTree(boxes).forEachAlong({0, 0, 0}, {99, 99, 0}, 0.1, [&](std::uint32_t item) {
    EXPECT_EQ(item % 100, item / 100);  // the posts of the diagonal
    ++visited;
  });
  EXPECT_EQ(visited, 100u);
}

TEST(BoundingTree, IsTheSameForTheSameBoxes) {
  Random random(3);
  const std::vector<Bounds> boxes = randomBoxes(random, 3000, 1, Vector3::Zero());
  const BoundingTree a(boxes), b(boxes);
  for (int query = 0; query < 100; ++query) {
    const Vector3 p = random.vector<Vector3>(-1, 1);
    EXPECT_EQ(near(a, p, 0.1), near(b, p, 0.1));
  }
}

TEST(BoundingTree, RenumbersAlongItself) {
  Random random(4);
  const std::vector<Bounds> boxes = randomBoxes(random, 1000, 1, Vector3::Zero());
  const BoundingTree tree(boxes);
  BoundingTree renumbered = tree;
  const std::vector<std::uint32_t> before = renumbered.renumber();
  for (std::uint32_t i = 0; i < boxes.size(); ++i) EXPECT_EQ(sorted(before)[i], i);
  for (int query = 0; query < 100; ++query) {
    const Vector3 p = random.vector<Vector3>(-1, 1);
    std::vector<std::uint32_t> found = near(renumbered, p, 0.2);
    for (std::uint32_t& item : found) item = before[item];
    EXPECT_EQ(found, near(tree, p, 0.2));
  }
}

}  // namespace
}  // namespace haptiv
