#include "haptics/shapes/TwoBoxes.h"

#include <gtest/gtest.h>

#include "haptics/shapes/StraightBoxSurface.h"
#include "tests/haptics/RandomShapes.h"

namespace haptiv {
namespace {

using testing::RandomShapes;

/// A place in front of a face, an edge or a corner of the first box, on its surface now and then, or inside.
Vector3 placeBeside(RandomShapes& random, const Shape& shape, int round) {
  if (round % 16 == 0) return random.onSurface(shape);
  return shape.centre + random.vector(1.5);
}

TEST(TwoBoxes, AreMeasuredAsEachByItself) {
  RandomShapes random(31);
  int outside = 0;
  for (int round = 0; round < 20'000; ++round) {
    const std::array<Shape, 2> shapes{random.shape(Shape::Kind::box), random.shape(Shape::Kind::box)};
    const std::array<StraightBox, 2> boxes{straightBox(shapes[0]).value(), straightBox(shapes[1]).value()};
    const Vector3 p = placeBeside(random, shapes[0], round);
    const TwoSurfaces two = measureTwo(p, boxes[0], boxes[1]);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto lane = static_cast<int>(i);
      const SurfacePoint alone = nearestOnStraightBox(boxes[i], BesideBox(boxes[i], p));
      ASSERT_EQ(two.isOutside[lane] != 0, alone.distance > 0);
      if (two.isOutside[lane] == 0) continue;
      ++outside;
      EXPECT_EQ(two.distance[lane], alone.distance);
      EXPECT_EQ(two.face[lane], alone.face);
      EXPECT_EQ(Vector3(two.normal[0][lane], two.normal[1][lane], two.normal[2][lane]), alone.normal);
    }
  }
  EXPECT_GT(outside, 10'000);
}

/// Before a face of an upright box the normal is the face's to the last bit, as is the distance.
TEST(TwoBoxes, AreExactBeforeUprightFaces) {
  Shape cube;
  cube.centre = {0.1, 0.2, 0.3};
  const StraightBox box = straightBox(cube).value();
  const TwoSurfaces two = measureTwo({0.1, 0.2, 3.3}, box, box);
  EXPECT_EQ(two.distance[0], 2);
  EXPECT_EQ(Vector3(two.normal[0][0], two.normal[1][0], two.normal[2][0]), Vector3(0, 0, 1));
  EXPECT_EQ(two.face[0], 4);
}

}  // namespace
}  // namespace haptiv
