#include <gtest/gtest.h>

#include "haptics/scene/NearShapes.h"
#include "tests/haptics/RandomShapes.h"

namespace haptiv {
namespace {

using testing::RandomShapes;

TEST(StraightBox, MeasuresAsTheImplicitBoxDoes) {
  RandomShapes random(11);
  for (int run = 0; run < 2000; ++run) {
    const Shape shape = random.shape(Shape::Kind::box);
    const auto box = straightBox(shape);
    ASSERT_TRUE(box.has_value());
    const Vector3 p = shape.centre + random.vector(1.5);
    const SurfacePoint nearest = nearestOnStraightBox(*box, BesideBox(*box, p));
    const Vector3 foot = p - nearest.distance * nearest.normal;
    EXPECT_NEAR(testing::implicitValue(shape, foot), 0, 1e-9);  // the foot is on the surface ...
    EXPECT_NEAR(nearest.normal.norm(), 1, 1e-12);
    EXPECT_EQ(nearest.distance < 0, testing::implicitValue(shape, p) < 0);
    for (int i = 0; i < 50; ++i) EXPECT_GE((random.onSurface(shape) - p).norm(), std::abs(nearest.distance) - 1e-12);
  }
}

TEST(StraightBox, IsNoSkewedAndNoFlatOne) {
  RandomShapes random(12);
  for (int run = 0; run < 200; ++run) EXPECT_FALSE(straightBox(random.skewedBox()).has_value());
  Shape flat = random.shape(Shape::Kind::box);
  flat.axes.col(1).setZero();
  EXPECT_FALSE(straightBox(flat).has_value());
}

/// Transforms come in single precision: their rounding makes no angle other than a right one.
TEST(StraightBox, AllowsForSinglePrecision) {
  RandomShapes random(13);
  for (int run = 0; run < 200; ++run) {
    Shape shape = random.shape(Shape::Kind::box);
    shape.axes = shape.axes.cast<float>().cast<double>();
    EXPECT_TRUE(straightBox(shape).has_value());
  }
}

TEST(ShapeIndex, FindsShapesByTheirId) {
  RandomShapes random(14);
  HapticScene scene;
  for (const ShapeId id : {7U, 3U, 900U, 4U, 0U, 12U, 3U}) {
    Wall wall;
    wall.id = id;
    wall.shape = random.shape(Shape::Kind::box);
    scene.walls.push_back(wall);
  }
  for (const bool prepared : {false, true}) {
    if (prepared) computeBounds(scene);
    EXPECT_EQ(findShape(scene.walls, scene.wallIndex, 900), 2u);
    EXPECT_EQ(findShape(scene.walls, scene.wallIndex, 0), 4u);
    EXPECT_EQ(findShape(scene.walls, scene.wallIndex, 3), 1u);  // the first of two
    EXPECT_EQ(findShape(scene.walls, scene.wallIndex, 5), scene.walls.size());
    EXPECT_EQ(findShape(scene.walls, scene.wallIndex, 1000), scene.walls.size());
  }
}

TEST(ShapeIndex, FindsWhatAScanOverAllShapesFinds) {
  RandomShapes random(15);
  HapticScene scene;
  for (int i = 0; i < 500; ++i) {
    Wall wall;
    wall.id = static_cast<ShapeId>(i);
    wall.shape = i % 5 == 4 ? random.skewedBox() : random.shape(static_cast<Shape::Kind>(i % 5), 0.3);
    wall.shape.centre = random.vector(2);
    scene.walls.push_back(wall);
  }
  computeBounds(scene);
  for (int run = 0; run < 300; ++run) {
    const Vector3 p = random.vector(2.5);
    const double reach = random.between(0.001, 0.5);
    std::vector<double> scanned(scene.walls.size(), -1), found = scanned;
    const auto into = [](std::vector<double>& list) {
      return [&list](std::size_t i, const SurfacePoint& surface) { list[i] = surface.distance; };
    };
    forEachNear(scene.walls, ShapeIndex(), p, reach, into(scanned));
    forEachNear(scene.walls, scene.wallIndex, p, reach, into(found));
    EXPECT_EQ(found, scanned);
  }
}

}  // namespace
}  // namespace haptiv
