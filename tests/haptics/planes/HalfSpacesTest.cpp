#include "haptics/planes/HalfSpaces.h"

#include <gtest/gtest.h>

#include "tests/haptics/RandomShapes.h"

namespace haptiv {
namespace {

using testing::RandomShapes;

constexpr double kGive = 1.0 / 128;  // of the way: how far planes give way where they are neither alone nor orthogonal

/// A few planes through about the same place; some are almost parallel, some the same.
HalfSpaces<8> randomPlanes(RandomShapes& random, int count) {
  HalfSpaces<8> spaces;
  for (int j = 0; j < count; ++j) {
    const auto before = static_cast<std::size_t>(j - 1);
    if (j > 0 && random.between(0, 1) < 0.3) {
      const Vector3 n = (spaces.normal[before] + random.between(0, 1e-3) * random.direction()).normalized();
      spaces.add(n, spaces.offset[before] + random.between(-1e-4, 1e-4));
    } else {
      spaces.add(random.direction(), random.between(-0.01, 0.01));
    }
  }
  return spaces;
}

TEST(HalfSpaces, AreExactForOnePlaneAndForOrthogonalOnes) {
  RandomShapes random(2);
  for (int i = 0; i < 200; ++i) {
    const Matrix3 R = random.rotation();
    HalfSpaces<4> spaces;
    for (int j = 0; j < 1 + i % 3; ++j) spaces.add(R.col(j), random.between(-0.01, 0.01));
    const Vector3 p = random.vector(0.01);
    const Vector3 x = spaces.nearest(p);
    for (int j = 0; j < spaces.count; ++j) {
      const auto k = static_cast<std::size_t>(j);
      const double missing = std::max(0.0, spaces.offset[k] - R.col(j).dot(p));
      // Alone, to the last bits; together, where one is hardly met at all, by the stretching of the others.
      EXPECT_NEAR(spaces.share[k], missing, (spaces.count == 1 ? 1e-12 : kGive) * (x - p).norm() + 1e-15);
    }
  }
}

TEST(HalfSpaces, ShareAlikeWherePlanesCoincide) {
  HalfSpaces<4> spaces;
  for (int j = 0; j < 4; ++j) spaces.add(Vector3::UnitZ(), 0.01);
  EXPECT_LT((spaces.nearest({1, 2, 0}) - Vector3(1, 2, 0.01)).norm(), 1e-15);
  for (const double share : spaces.share) EXPECT_NEAR(share, 0.0025, 1e-15);
}

TEST(HalfSpaces, DoNotDependOnTheirOrder) {
  RandomShapes random(3);
  for (int i = 0; i < 2000; ++i) {
    HalfSpaces<8> spaces = randomPlanes(random, 2 + i % 6), reversed;
    for (int j = spaces.count; j-- > 0;) {
      reversed.add(spaces.normal[static_cast<std::size_t>(j)], spaces.offset[static_cast<std::size_t>(j)]);
    }
    const Vector3 p = random.vector(0.02);
    const Vector3 x = spaces.nearest(p), y = reversed.nearest(p);
    EXPECT_LT((x - y).norm(), 1e-12);
    for (int j = 0; j < spaces.count; ++j) {
      EXPECT_NEAR(spaces.share[static_cast<std::size_t>(j)],
                  reversed.share[static_cast<std::size_t>(spaces.count - 1 - j)], 1e-9);
    }
  }
}

/// Almost parallel planes among them, between which the exact shares would jump.
TEST(HalfSpaces, ChangeTheirSharesContinuously) {
  RandomShapes random(4);
  for (int i = 0; i < 3000; ++i) {
    HalfSpaces<8> spaces = randomPlanes(random, 1 + i % 7);
    const Vector3 p = random.vector(0.02);
    const double step = 1e-7;
    spaces.nearest(p);
    const std::array<double, 8> before = spaces.share;
    for (int j = 0; j < spaces.count; ++j) spaces.offset[static_cast<std::size_t>(j)] += random.between(-step, step);
    spaces.nearest(p + step * random.direction());
    for (int j = 0; j < spaces.count; ++j) {
      const auto k = static_cast<std::size_t>(j);
      EXPECT_LT(std::abs(spaces.share[k] - before[k]), 8 * step / kGive);
    }
  }
}

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
    if (std::abs(a.cross(b).dot(c)) < 0.1) continue;  // in needle-like corners the shares are longer than the way
    const Vector3 p = inAll - Vector3(0, 0, random.between(0, 0.2)) + random.vector(0.05);
    const Vector3 x = spaces.nearest(p);
    Vector3 way = Vector3::Zero();
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_GE(spaces.normal[j].dot(x), spaces.offset[j] - 1e-12);
      EXPECT_GE(spaces.share[j], 0);
      way += spaces.share[j] * spaces.normal[j];
    }
    EXPECT_LE((p + way - x).norm(), 6 * kGive * (x - p).norm());
    // Of a convex set x is the nearest point: towards any other of its points the way from p only gets longer.
    for (int k = 0; k < 10; ++k) {
      Vector3 other = inAll + random.vector(0.1);
      for (std::size_t j = 0; j < 3; ++j) {
        const double lacking = spaces.offset[j] - spaces.normal[j].dot(other);
        if (lacking > 0) other += lacking / spaces.normal[j].z() * Vector3::UnitZ();  // all of them face upwards
      }
      EXPECT_LE((other - x).dot(p - x), 1e-12);
    }
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
