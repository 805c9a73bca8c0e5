#include "haptics/meshes/TwoTriangles.h"

#include <gtest/gtest.h>

#include "haptics/meshes/TrianglePoint.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

using test::Random;

/// One triangle in four is a line or a point.
std::array<Vector3, 3> randomTriangle(Random& random) {
  const Vector3 a = random.vector<Vector3>(-1, 1), b = random.vector<Vector3>(-1, 1);
  const double kind = random.between(0, 1);
  if (kind < 0.1) return {a, a, a};
  if (kind < 0.2) return {a, b, random.between(0, 1) < 0.5 ? a : b};
  if (kind < 0.25) return {a, b, a + random.between(-1, 2) * (b - a)};
  return {a, b, random.vector<Vector3>(-1, 1)};
}

TEST(TwoTriangles, AreAsFarAsEachByItself) {
  Random random(11);
  for (int round = 0; round < 20000; ++round) {
    const std::array<std::array<Vector3, 3>, 2> corners{randomTriangle(random), randomTriangle(random)};
    TwoTriangles two;
    for (std::size_t i = 0; i < 2; ++i) two[i] = {&corners[i][0], &corners[i][1], &corners[i][2]};
    const Vector3 p = round % 8 == 0 ? corners[0][0] : random.vector<Vector3>(-2, 2);
    TwoDistances distances;
    measureTwo(p, two, distances);
    for (std::size_t i = 0; i < 2; ++i) {
      const int lane = static_cast<int>(i);
      const Vector3 away = p - closestOnTriangle(p, *two[i][0], *two[i][1], *two[i][2]);
      const Vector3 measured(distances.away[0][lane], distances.away[1][lane], distances.away[2][lane]);
      // In a triangle that is nearly a line, rounding decides which of two places as near is taken: distances, then.
      EXPECT_NEAR(measured.norm(), away.norm(), 1e-9);
      EXPECT_NEAR(distances.squared[lane], away.squaredNorm(), 1e-8);
    }
  }
}

}  // namespace
}  // namespace haptiv
