#include "haptics/contact/FirstTouch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "haptics/meshes/TrianglePoint.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

using test::Random;

struct Triangle {
  Vector3 a, b, c;

  Vector3 away(const Vector3& p) const { return p - closestOnTriangle(p, a, b, c); }
};

double gapAt(const BallWay& way, const Triangle& triangle, double along) {
  return triangle.away(way.from + along * way.direction).norm() - way.radius;
}

/// The smallest gap up to `end`: it is convex.
double smallestGap(const BallWay& way, const Triangle& triangle, double end) {
  double low = 0, high = end;
  for (int i = 0; i < 200; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (gapAt(way, triangle, a) < gapAt(way, triangle, b)) {
      high = b;
    } else {
      low = a;
    }
  }
  return std::min(gapAt(way, triangle, low), gapAt(way, triangle, end));
}

/// A ball outside of a triangle and a way that leads about there.
struct Case {
  Triangle triangle;
  BallWay way;

  explicit Case(Random& random) {
    const double size = std::pow(10, random.between(-1, 1));
    triangle = {size * random.vector<Vector3>(-1, 1), size * random.vector<Vector3>(-1, 1),
                size * random.vector<Vector3>(-1, 1)};
    const double radius = std::pow(10, random.between(-1, 1));
    const double b = random.between(0, 1), c = random.between(0, 1 - b);
    const Vector3 on = triangle.a + b * (triangle.b - triangle.a) + c * (triangle.c - triangle.a);
    Vector3 from;
    do from = on + 3 * radius * random.vector<Vector3>(-1, 1);
    while (triangle.away(from).norm() < radius);
    const Vector3 target = on + radius * random.vector<Vector3>(-1, 1);
    const double length = (target - from).norm() * random.between(0.5, 2);
    way = {from, (target - from).normalized(), length, radius, 1e-7 * radius};
  }
};

TEST(FirstTouch, StopsWhereTheBallTouchesAndNotBefore) {
  Random random(31);
  int stopped = 0, measured = 0;
  for (int round = 0; round < 20000; ++round) {
    const Case each(random);
    const double gone = wayToTouch(each.way, 0, each.way.length, [&](const Vector3& p) {
      ++measured;
      return each.triangle.away(p);
    });
    if (!(gone < each.way.length)) continue;
    ++stopped;
    EXPECT_LE(gapAt(each.way, each.triangle, gone), each.way.tolerance);
    EXPECT_GE(smallestGap(each.way, each.triangle, gone), -1e-12 * each.way.radius);
  }
  EXPECT_GT(stopped, 8000);
  EXPECT_LT(measured, 4 * 20000);
}

TEST(FirstTouch, LetsTheBallPassWhatItOnlyGrazes) {
  Random random(32);
  int passed = 0, grazed = 0;
  for (int round = 0; round < 20000; ++round) {
    Case each(random);
    BallWay& way = each.way;
    way.direction = random.vector<Vector3>(-1, 1).normalized();  // now it passes the first corner
    const Vector3 beside = way.direction.cross(random.vector<Vector3>(-1, 1)).normalized();
    const double before = way.radius * std::pow(10, random.between(-3, 0));
    way.from = each.triangle.a + (1 - 5e-4 * random.between(-1, 1)) * way.radius * beside - before * way.direction;
    if (gapAt(way, each.triangle, 0) < 0) continue;
    const double least = smallestGap(way, each.triangle, way.length);
    const double gone = wayToTouch(way, 0, way.length, [&](const Vector3& p) { return each.triangle.away(p); });
    EXPECT_TRUE(gone == way.length || least < 0);
    if (gone < way.length) continue;
    ++passed;
    grazed += least < 0 ? 1 : 0;
    EXPECT_GE(least, -std::min(1e-3 * way.length, way.radius / 8));
  }
  EXPECT_GT(passed, 3000);
  EXPECT_GT(grazed, 300);
}

/// A ball that rolls on a floor comes to a bump in it, the edge of a triangle that is `height` radii above the floor.
double wayOverBump(double height, int& measured) {
  const Triangle bump{{0.05, -1, height}, {0.05, 1, height}, {1, 0, -0.5}};
  const BallWay way{{0, 0, 1}, Vector3::UnitX(), 0.5, 1, 1e-7};
  return wayToTouch(way, 0, 0.5, [&](const Vector3& p) {
    ++measured;
    return bump.away(p);
  });
}

TEST(FirstTouch, SeesAtOnceThatABumpIsPassed) {
  int measured = 0;
  EXPECT_EQ(wayOverBump(1e-4, measured), 0.5);
  EXPECT_EQ(wayOverBump(0, measured), 0.5);
  EXPECT_EQ(wayOverBump(-1e-4, measured), 0.5);
  EXPECT_LE(measured, 10);
  EXPECT_NEAR(wayOverBump(1e-3, measured), 0.05 - std::sqrt(2e-3 - 1e-6), 1e-5);
}

TEST(FirstTouch, GoesOnFromWithinWhereItLeadsOut) {
  const Triangle floor{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}};
  const auto go = [&](const Vector3& from, const Vector3& direction) {
    return wayToTouch({from, direction, 1, 1, 1e-7}, 0, 1, [&](const Vector3& p) { return floor.away(p); });
  };
  EXPECT_EQ(go({0, 0, 0.9}, Vector3::UnitZ()), 1);
  EXPECT_EQ(go({0, 0, 0.9}, Vector3::UnitX()), 1);
  EXPECT_EQ(go({0, 0, 0.9}, -Vector3::UnitZ()), 0);
  EXPECT_EQ(go({0, 0, 0}, Vector3::UnitZ()), 1) << "nothing tells from which side it came";
}

}  // namespace
}  // namespace haptiv
