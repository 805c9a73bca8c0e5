#include "haptics/laws/FreeMotion.h"

#include <gtest/gtest.h>

#include "tests/haptics/RandomShapes.h"

namespace haptiv {
namespace {

using testing::RandomShapes;

ContactSet contactsWith(std::initializer_list<Vector3> normals) {
  ContactSet contacts;
  for (const Vector3& normal : normals) {
    contacts.contact[static_cast<std::size_t>(contacts.count++)].normal = normal.normalized();
  }
  return contacts;
}

TEST(FreeMotion, IsDampedInEveryDirectionWithoutAContact) {
  EXPECT_LT((freeMotionForce({1, 2, 3}, {}, 5) + 5 * Vector3(1, 2, 3)).norm(), 1e-12);
}

TEST(FreeMotion, IsDampedOnlyAlongTheWallInContact) {
  RandomShapes random(1);
  for (int i = 0; i < 500; ++i) {
    const Vector3 n = random.direction(), v = random.vector(1);
    const Vector3 free = freeVelocity(v, contactsWith({n}));
    EXPECT_NEAR(free.dot(n), 0, 1e-12);
    EXPECT_LT((free - (v - v.dot(n) * n)).norm(), 1e-12);
  }
}

TEST(FreeMotion, IsDampedOnlyAlongTheEdgeBetweenTwoWallsHoweverOblique) {
  RandomShapes random(2);
  for (int i = 0; i < 500; ++i) {
    const Vector3 a = random.direction(), b = random.direction(), v = random.vector(1);
    if (a.cross(b).norm() < 0.1) continue;
    const Vector3 edge = a.cross(b).normalized();
    EXPECT_LT((freeVelocity(v, contactsWith({a, b, a})) - v.dot(edge) * edge).norm(), 1e-9);
  }
}

TEST(FreeMotion, IsNothingInACornerOfThreeWalls) {
  EXPECT_EQ(freeVelocity({1, 2, 3}, contactsWith({{1, 0, 0}, {0, 1, 0.1}, {0.2, 0, 1}})), Vector3::Zero());
}

}  // namespace
}  // namespace haptiv
