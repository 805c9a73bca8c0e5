#include "haptics/index/RememberedBoxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/haptics/index/RandomBoxes.h"

namespace haptiv {
namespace {

using test::Random;
using testing::near;
using testing::randomBoxes;
using testing::sorted;

/// Remembers as it is told, and takes an item for its number.
struct Keeper {
  RememberedBoxes::Ahead toRemember;
  std::vector<std::uint32_t>* told = nullptr;  ///< what it is told of

  RememberedBoxes::Ahead ahead() const { return toRemember; }
  void gathered(std::uint32_t item) const {
    if (told != nullptr) told->push_back(item);
  }
  std::uint32_t number(std::uint32_t item) const { return item; }
};

/// Where they are not remembered, as the tree finds them.
std::vector<std::uint32_t> nearBy(RememberedBoxes& boxes, const BoundingTree& tree, const Vector3& p, double reach,
                                  const Keeper& keeper) {
  const auto items = boxes.near(tree, p, reach, keeper);
  return items ? std::vector(items->begin(), items->end()) : sorted(near(tree, p, reach));
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
        ASSERT_EQ(nearBy(boxes, tree, p, reach, {{margin, 64 * step}}), sorted(near(tree, p, reach)));
        p += step;
      }
    }
  }
}

/// Nothing is remembered of which it was not told before.
TEST(RememberedBoxes, TellsWhatItRemembersAnew) {
  Random random(6);
  const BoundingTree tree(randomBoxes(random, 400, 1, {0, 0, 0}));
  RememberedBoxes boxes;
  std::vector<std::uint32_t> told;
  Vector3 p(-1, -1, -1);
  int remembered = 0;
  for (int tick = 0; tick < 2000; ++tick) {
    const Vector3 step = random.vector<Vector3>(0, 0.002);
    const auto items = boxes.near(tree, p, 0.1, Keeper{{0.05, 64 * step}, &told});
    p += step;
    if (!items) continue;
    ++remembered;
    for (const std::uint32_t item : *items) EXPECT_NE(std::find(told.begin(), told.end(), item), told.end());
  }
  EXPECT_GT(remembered, 1000);
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
    std::vector<std::uint32_t> told;
    EXPECT_TRUE(boxes.near(tree, {0.05 * tick, 0.5, 0.5}, 0.1, Keeper{{2.5, {6, 0, 0}}, &told}));
    if (tick > 0) most = std::max(most, told.size());
    all += told.size();
  }
  EXPECT_GT(all, 1000U);
  EXPECT_LE(most, BoxNode::kWidth);
}

TEST(RememberedBoxes, ForgetsOneTreeForAnother) {
  const std::vector<Bounds> some = {{{0, 0, 0}, {1, 1, 1}}, {{2, 0, 0}, {3, 1, 1}}};
  const std::vector<Bounds> others = {{{5, 5, 5}, {6, 6, 6}}, {{0, 0, 0}, {1, 1, 1}}};
  RememberedBoxes boxes;
  const Vector3 p(0.5, 0.5, 0.5);
  EXPECT_EQ(nearBy(boxes, BoundingTree(some), p, 0.1, {{1}}), std::vector<std::uint32_t>{0});
  boxes.forget();
  EXPECT_EQ(nearBy(boxes, BoundingTree(others), p, 0.1, {{1}}), std::vector<std::uint32_t>{1});
}

TEST(RememberedBoxes, OutlivesPlacesThatAreNone) {
  const BoundingTree tree(std::vector<Bounds>{{{0, 0, 0}, {1, 1, 1}}});
  for (const double odd : {double{NAN}, double{INFINITY}, 1e300, -1e300}) {
    RememberedBoxes boxes;
    nearBy(boxes, tree, Vector3::Constant(odd), 0.1, {{1, Vector3::Constant(odd)}});
    EXPECT_EQ(nearBy(boxes, tree, {0.5, 0.5, 0.5}, 0.1, {{1}}), std::vector<std::uint32_t>{0});
  }
}

}  // namespace
}  // namespace haptiv
