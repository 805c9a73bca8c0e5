#include "haptics/meshes/BlockBounds.h"

#include <gtest/gtest.h>

#include <bit>

#include "haptics/meshes/TrianglePoint.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

using test::Random;

/// One triangle in four is a line or a point.
void addTriangle(Random& random, double size, const Vector3& place, std::vector<Vector3>& vertices,
                 std::vector<TriangleCorners>& triangles) {
  const auto first = static_cast<std::uint32_t>(vertices.size());
  const auto anywhere = [&] { return Vector3(place + size * random.vector<Vector3>(-1, 1)); };
  const Vector3 a = anywhere(), b = anywhere();
  const double kind = random.between(0, 1);
  vertices.push_back(a);
  vertices.push_back(kind < 0.1 ? a : b);
  vertices.push_back(kind < 0.2 ? a : kind < 0.25 ? Vector3(a + random.between(-1, 2) * (b - a)) : anywhere());
  triangles.push_back({first, first + 1, first + 2});
}

struct Few {
  std::vector<Vector3> vertices;
  std::vector<TriangleCorners> triangles;

  double distance(std::size_t triangle, const Vector3& p) const {
    const auto [a, b, c] = triangles[triangle];
    return (p - closestOnTriangle(p, vertices[a], vertices[b], vertices[c])).norm();
  }
};

Few randomFew(Random& random, double size, const Vector3& place) {
  Few few;
  for (std::size_t i = 0; i < TriangleBlock::kSize; ++i) addTriangle(random, size, place, few.vertices, few.triangles);
  return few;
}

double along(const BlockBounds& bounds, int lane, const Vector3& step) {
  return Vector3(bounds.normal[0][lane], bounds.normal[1][lane], bounds.normal[2][lane]).dot(step);
}

TEST(BlockBounds, HoldForAllPlacesAndAreTightWhereTheyWereMade) {
  Random random(11);
  int tight = 0, rounds = 5000;
  for (int round = 0; round < rounds; ++round) {
    const double size = std::pow(10, random.between(-4, 2));
    const Vector3 place = (round % 2) * 10 * size * random.vector<Vector3>(-1, 1);
    const Few few = randomFew(random, size, place);
    const TriangleBlock block = makeBlocks(few.vertices, few.triangles)[0];
    const Vector3 p = round % 8 == 0 ? few.vertices[0] : Vector3(place + 2 * size * random.vector<Vector3>(-1, 1));
    BlockBounds bounds;
    boundBlock(block, p, bounds);
    for (std::size_t i = 0; i < TriangleBlock::kSize; ++i) {
      const int lane = static_cast<int>(i);
      const double distance = few.distance(i, p), bound = bounds.distance[lane];
      ASSERT_LE(bound, distance);
      if (distance - bound < 2e-4 * size) ++tight;
      for (int k = 0; k < 5; ++k) {
        const Vector3 step = 2 * size * random.vector<Vector3>(-1, 1);
        ASSERT_LE(bound + along(bounds, lane, step), few.distance(i, p + step) + 1e-6 * size);
      }
    }
  }
  EXPECT_GT(tight, 0.8 * rounds * static_cast<int>(TriangleBlock::kSize));  // the others are lines, points, or touched
}

TEST(BlockBounds, FindAllThatAreNearAWay) {
  Random random(12);
  int near = 0, found = 0;
  for (int round = 0; round < 5000; ++round) {
    const Few few = randomFew(random, 1, Vector3::Zero());
    const Vector3 p = 2 * random.vector<Vector3>(-1, 1), half = random.vector<Vector3>(-1, 1);
    const double reach = random.between(0, 2);
    BlockBounds bounds;
    boundBlock(makeBlocks(few.vertices, few.triangles)[0], p, bounds);
    const unsigned bits =
        bounds.nearWay({static_cast<float>(half.x()), static_cast<float>(half.y()), static_cast<float>(half.z())},
                       static_cast<float>(reach));
    found += std::popcount(bits);
    for (std::size_t i = 0; i < TriangleBlock::kSize; ++i) {
      bool isNear = false;
      for (double at = -1; at <= 1; at += 0.125) isNear = isNear || few.distance(i, p + at * half) < reach - 1e-5;
      near += isNear ? 1 : 0;
      if (isNear) {
        ASSERT_TRUE((bits >> i & 1U) != 0);
      }
    }
  }
  EXPECT_LT(found, 1.3 * near);
}

TEST(BlockBounds, OfTrianglesTooFarApartToTellSayNothing) {
  const std::vector<Vector3> vertices{{0, 0, 0}, {1e90, 0, 0}, {0, -1e90, 0}};
  BlockBounds bounds;
  boundBlock(makeBlocks(vertices, {{0, 1, 2}})[0], {0, 0, 1e-3}, bounds);
  for (int lane = 0; lane < 4; ++lane) {
    for (const double x : {-1e9, -1.0, 0.0, 1.0, 1e9})
      EXPECT_LE(bounds.distance[lane] + along(bounds, lane, {x, x, 0}), 1e-3);
  }
  EXPECT_NE(bounds.nearWay({0, 0, 0}, 1), 0U);
}

TEST(TriangleBlock, WhereTheTrianglesEndHoldsTheLastOneAgain) {
  Random random(13);
  Few few;
  for (int i = 0; i < 6; ++i) addTriangle(random, 1, Vector3::Zero(), few.vertices, few.triangles);
  const std::vector<TriangleBlock> blocks = makeBlocks(few.vertices, few.triangles);
  ASSERT_EQ(blocks.size(), 2u);
  BlockBounds bounds;
  boundBlock(blocks[1], {3, 0, 0}, bounds);
  EXPECT_EQ(bounds.distance[1], bounds.distance[2]);
  EXPECT_EQ(bounds.distance[1], bounds.distance[3]);
}

}  // namespace
}  // namespace haptiv
