#include "haptics/HalfSpaces.h"

#include <gtest/gtest.h>

#include "tests/haptics/RandomShapes.h"

namespace haptiv {
namespace {

using testing::RandomShapes;

TEST(HalfSpaces, GiveTheNearestPointThatIsInAllOfThem) {
  RandomShapes random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vector3 inAll = random.vector(0.1);
    HalfSpaces<4> spaces;
    for (int j = 0; j < 3; ++j) {
      const Vector3 n = (random.direction() + Vector3(0, 0, 1.5)).normalized();
      spaces.add(n, n.dot(inAll) - random.between(0, 0.02));
    }
    const Vector3 &a = spaces.normal[0], &b = spaces.normal[1], &c = spaces.normal[2];
    if (std::abs(a.cross(b).dot(c)) < 0.1)
      continue;  // needle-like corners and almost parallel planes settle more slowly still
    const Vector3 p = inAll - Vector3(0, 0, random.between(0, 0.2)) + random.vector(0.05);
    const Vector3 x = spaces.nearest(p);
    Vector3 way = Vector3::Zero();
    for (std::size_t j = 0; j < 3; ++j) {
      const double room = spaces.normal[j].dot(x) - spaces.offset[j];
      EXPECT_GE(room, -1e-3 * (x - p).norm() - 1e-15);
      EXPECT_GE(spaces.share[j], 0);
      EXPECT_LE(spaces.share[j] * room,
                1e-3 * (x - p).squaredNorm());  // only what touches pushes: the condition for the nearest point
      way += spaces.share[j] * spaces.normal[j];
    }
    EXPECT_LT((p + way - x).norm(), 1e-12);
  }
}

TEST(HalfSpaces, LeaveAPointAloneThatIsInAllOfThem) {
  HalfSpaces<2> spaces;
  spaces.add(Vector3::UnitX(), -1);
  spaces.add(Vector3::UnitY(), -1);
  EXPECT_EQ(spaces.nearest({0.5, 0.5, 0.5}), Vector3(0.5, 0.5, 0.5));
}

TEST(HalfSpaces, GiveAPointBetweenWhereNoPointIsInAllOfThem) {
  HalfSpaces<2> spaces;
  spaces.add(Vector3::UnitX(), 1);
  spaces.add(-Vector3::UnitX(), 1);
  EXPECT_LE(std::abs(spaces.nearest({0.2, 0, 0}).x()), 1 + 1e-9);
}

}  // namespace
}  // namespace haptiv
