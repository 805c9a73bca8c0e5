#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/haptics/index/RandomBoxes.h"

namespace haptiv {
namespace {

using test::Random;
using testing::near;

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kMax = std::numeric_limits<double>::max();

Bounds cube(const Vector3& middle, double half) {
  return {middle.array() - half, middle.array() + half};
}

TEST(HostileBoxes, NoneAtAll) {
  const BoundingTree none, empty{std::vector<Bounds>()};
  for (const BoundingTree* tree : {&none, &empty}) {
    EXPECT_TRUE(near(*tree, {0, 0, 0}, kInf).empty());
    EXPECT_EQ(tree->nearest({0, 0, 0}, 3, [](std::uint32_t) { return 0.0; }), 3);
  }
}

TEST(HostileBoxes, AllOnOneSpot) {
  const std::vector<Bounds> boxes(50000, cube({1, 2, 3}, 0));
  const BoundingTree tree(boxes);
  EXPECT_EQ(near(tree, {1, 2, 3}, 0).size(), 50000u);
  EXPECT_TRUE(near(tree, {1, 2, 3.001}, 0.0005).empty());
}

/// Each cut of such a row takes few boxes off its end: the deepest tree that there is.
TEST(HostileBoxes, EachTwiceAsFarAsTheOneBefore) {
  std::vector<Bounds> boxes;
  for (int i = -1000; i < 1000; ++i) {
    for (int k = 0; k < 20; ++k) boxes.push_back(cube({std::ldexp(1.0, i), 0, 0}, 0));
  }
  const BoundingTree tree(boxes);
  for (const int i : {-120, -20, 0, 20, 100}) {
    const std::size_t found = near(tree, {std::ldexp(1.0, i), 0, 0}, std::ldexp(0.1, i)).size();
    EXPECT_GE(found, 20u);
  }
  EXPECT_EQ(near(tree, {0, 0, 0}, kInf).size(), boxes.size());
}

TEST(HostileBoxes, InfiniteOrNoNumbers) {
  std::vector<Bounds> boxes;
  for (int i = 0; i < 100; ++i) boxes.push_back(cube({0.01 * i, 0, 0}, 0.001));
  boxes.push_back({Vector3::Constant(-kInf), Vector3::Constant(kInf)});
  boxes.push_back({Vector3::Constant(kNan), Vector3::Constant(kNan)});
  boxes.push_back({{-kInf, -0.001, -0.001}, {kInf, 0.001, 0.001}});
  boxes.push_back({Vector3::Constant(-kMax), Vector3::Constant(kMax)});
  const BoundingTree tree(boxes);
  EXPECT_EQ(testing::sorted(near(tree, {0.5, 0, 0}, 0.001)), (std::vector<std::uint32_t>{50, 100, 101, 102, 103}));
  EXPECT_EQ(testing::sorted(near(tree, {-1e300, 5, 0}, 1)), (std::vector<std::uint32_t>{100, 101, 103}));
  EXPECT_EQ(near(tree, {0, 0, 0}, kInf).size(), boxes.size());
}

/// Single precision ends at 3e38: beyond it boxes are found too early, never missed.
TEST(HostileBoxes, NumbersBeyondSinglePrecision) {
  std::vector<Bounds> boxes;
  for (const double x : {1e-320, 1e-45, 1.0, 1e30, 1e38, 1e100, 1e300, 1.7e308}) {
    boxes.push_back(cube({x, 0, 0}, x / 10));
    boxes.push_back(cube({-x, 0, 0}, x / 10));
  }
  const BoundingTree tree(boxes);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const Vector3 middle = 0.5 * boxes[i].low + 0.5 * boxes[i].high;
    const std::vector<std::uint32_t> found = near(tree, middle, 0);
    EXPECT_EQ(std::count(found.begin(), found.end(), i), 1) << i;
    bool met = false;
    tree.forEachAlong(Vector3::Zero(), middle, 0, [&](std::uint32_t item) { met = met || item == i; });
    EXPECT_TRUE(met) << i;
  }
}

TEST(HostileBoxes, QueriesWithoutNumbersEnd) {
  Random random(1);
  const std::vector<Bounds> boxes = testing::randomBoxes(random, 1000, 1, Vector3::Zero());
  const BoundingTree tree(boxes);
  std::size_t visited = 0;
  const auto count = [&](std::uint32_t item) {
    EXPECT_LT(item, boxes.size());
    ++visited;
  };
  for (const double a : {kNan, kInf, -kInf, kMax, -kMax, 0.0}) {
    for (const double reach : {kNan, kInf, kMax, 0.0, -1.0}) {
      tree.forEachNear(Vector3::Constant(a), reach, count);
      tree.forEachAlong(Vector3::Constant(a), Vector3::Constant(-a), reach, count);
      tree.nearest(Vector3::Constant(a), reach, [&](std::uint32_t item) {
        count(item);
        return a;
      });
    }
  }
  EXPECT_GE(visited, boxes.size());
}

}  // namespace
}  // namespace haptiv
