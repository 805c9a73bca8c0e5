#include "haptics/index/RememberedBoxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/haptics/index/RandomBoxes.h"

namespace haptiv {
namespace {

using test::Random;
using testing::near;
using testing::randomBoxes;
using testing::sorted;

std::vector<std::uint32_t> nearBy(RememberedBoxes& boxes, const BoundingTree& tree, const Vector3& p, double reach,
                                  const RememberedBoxes::Ahead& ahead) {
  std::vector<std::uint32_t> found;
  boxes.forEachNear(tree, p, reach, ahead, [&](std::uint32_t item) { found.push_back(item); });
  return sorted(found);
}

/// Slow and fast, through crowds (of more boxes than can be remembered) and past the end of them all.
TEST(RememberedBoxes, FindsWhatTheTreeFinds) {
  Random random(5);
  for (const double size : {1e-3, 1.0, 1e3}) {
    for (const std::size_t count : {1, 4, 40, 2000}) {
      const BoundingTree tree(randomBoxes(random, count, size, {0, 10 * size, 0}));
      RememberedBoxes boxes;
      Vector3 p(0, 10 * size, 0);
      for (int tick = 0; tick < 2000; ++tick) {
        const Vector3 step = random.vector<Vector3>(-1, 1) * size * std::pow(10, random.between(-4, -1));
        const double reach = size * std::pow(10, random.between(-2, -1));
        const double margin = tick % 10 == 0 ? 0 : 0.1 * size;
        ASSERT_EQ(nearBy(boxes, tree, p, reach, {margin, 64 * step}), sorted(near(tree, p, reach)));
        p += step;
      }
    }
  }
}

/// Nothing is visited of which it was not told before, as long as something is remembered.
TEST(RememberedBoxes, TellsWhatItRemembersAnew) {
  Random random(6);
  const BoundingTree tree(randomBoxes(random, 400, 1, {0, 0, 0}));
  RememberedBoxes boxes;
  std::set<std::uint32_t> told;
  Vector3 p(-1, -1, -1);
  for (int tick = 0; tick < 2000; ++tick) {
    const Vector3 step = random.vector<Vector3>(0, 0.002);
    boxes.forEachNear(
        tree, p, 0.1, {0.05, 64 * step}, [&](std::uint32_t item) { EXPECT_TRUE(told.contains(item)); },
        [&](std::uint32_t item) { told.insert(item); });
    p += step;
  }
  EXPECT_GT(told.size(), 20U);
}

/// Who goes on slowly is never kept waiting until all that lies ahead has been found.
TEST(RememberedBoxes, RemembersALittleInEachCall) {
  constexpr std::uint32_t kBoxes = 4096;
  std::vector<Bounds> row;
  for (std::uint32_t i = 0; i < kBoxes; ++i) row.push_back({{1.0 * i, 0, 0}, {i + 0.9, 1, 1}});
  const BoundingTree tree(row);
  RememberedBoxes boxes;
  std::size_t most = 0, all = 0;
  for (int tick = 0; tick < 20'000; ++tick) {
    std::size_t told = 0;
    boxes.forEachNear(
        tree, {0.05 * tick, 0.5, 0.5}, 0.1, {2.5, {6, 0, 0}}, [](std::uint32_t) {}, [&](std::uint32_t) { ++told; });
    if (tick > 0) most = std::max(most, told);
    all += told;
  }
  EXPECT_GT(all, 1000U);
  EXPECT_LE(most, BoxNode::kWidth);
}

TEST(RememberedBoxes, ForgetsOneTreeForAnother) {
  const std::vector<Bounds> some = {{{0, 0, 0}, {1, 1, 1}}, {{2, 0, 0}, {3, 1, 1}}};
  const std::vector<Bounds> others = {{{5, 5, 5}, {6, 6, 6}}, {{0, 0, 0}, {1, 1, 1}}};
  RememberedBoxes boxes;
  const Vector3 p(0.5, 0.5, 0.5);
  EXPECT_EQ(nearBy(boxes, BoundingTree(some), p, 0.1, {1}), std::vector<std::uint32_t>{0});
  boxes.forget();
  EXPECT_EQ(nearBy(boxes, BoundingTree(others), p, 0.1, {1}), std::vector<std::uint32_t>{1});
}

TEST(RememberedBoxes, OutlivesPlacesThatAreNone) {
  const BoundingTree tree(std::vector<Bounds>{{{0, 0, 0}, {1, 1, 1}}});
  for (const double odd : {double{NAN}, double{INFINITY}, 1e300, -1e300}) {
    RememberedBoxes boxes;
    nearBy(boxes, tree, Vector3::Constant(odd), 0.1, {1, Vector3::Constant(odd)});
    EXPECT_EQ(nearBy(boxes, tree, {0.5, 0.5, 0.5}, 0.1, {1}), std::vector<std::uint32_t>{0});
  }
}

}  // namespace
}  // namespace haptiv
