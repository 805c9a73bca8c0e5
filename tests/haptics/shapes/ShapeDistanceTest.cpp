#include "haptics/shapes/ShapeDistance.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "tests/haptics/RandomShapes.h"

namespace haptiv {
namespace {

using testing::implicitValue;
using testing::RandomShapes;

constexpr double kExact = 1e-12;  // rounding of doubles, for shapes and distances of about one metre

class ShapeDistance : public ::testing::TestWithParam<int> {
 protected:
  /// 0..3: the kinds; 4: a skewed box.
  Shape next() { return GetParam() == 4 ? random.skewedBox() : random.shape(static_cast<Shape::Kind>(GetParam())); }
  RandomShapes random{static_cast<unsigned>(GetParam()) + 1};
};

TEST_P(ShapeDistance, HasItsFootOnTheSurfaceAndTheRightSign) {
  for (int i = 0; i < 5000; ++i) {
    const Shape shape = next();
    const Vector3 p = shape.centre + random.vector(1.5);
    const SurfacePoint surface = nearestSurface(shape, p);
    EXPECT_NEAR(surface.normal.norm(), 1, kExact);
    EXPECT_EQ(surface.distance < 0, implicitValue(shape, p) < 0);
    // The implicit value is in half extents, of which the least is 0.05 m (less across a skewed box).
    EXPECT_NEAR(implicitValue(shape, p - surface.distance * surface.normal), 0, 200 * kExact);
  }
}

TEST_P(ShapeDistance, IsNotLongerThanToAnyPointOfTheSurface) {
  for (int i = 0; i < 200; ++i) {
    const Shape shape = next();
    const Vector3 p = shape.centre + random.vector(1.2);
    const double distance = std::abs(nearestSurface(shape, p).distance);
    for (int j = 0; j < 500; ++j) {
      EXPECT_LE(distance, (p - random.onSurface(shape)).norm() + kExact);
    }
  }
}

TEST_P(ShapeDistance, HasTheNormalAsItsGradient) {
  constexpr double kStep = 1e-6;
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const Shape shape = next();
    const Vector3 p = shape.centre + random.vector(1.5);
    const SurfacePoint surface = nearestSurface(shape, p);
    Vector3 gradient;
    bool smooth = true;
    for (int axis = 0; axis < 3; ++axis) {
      const SurfacePoint high = nearestSurface(shape, p + kStep * Vector3::Unit(axis));
      const SurfacePoint low = nearestSurface(shape, p - kStep * Vector3::Unit(axis));
      // On a medial surface the nearest point jumps, and there is no gradient.
      smooth = smooth && (high.normal - surface.normal).norm() < 1e-3 && (low.normal - surface.normal).norm() < 1e-3;
      gradient[axis] = (high.distance - low.distance) / (2 * kStep);
    }
    if (!smooth) continue;
    ++compared;
    // Error of central differences: half a step times the curvature, which is at most 1e-3 per step where smooth.
    EXPECT_LT((gradient - surface.normal).norm(), 1e-3);
  }
  EXPECT_GT(compared, 1900);
}

TEST_P(ShapeDistance, TurnsAndMovesWithTheShape) {
  for (int i = 0; i < 1000; ++i) {
    const Shape shape = next();
    const Vector3 p = shape.centre + random.vector(1.5);
    const Matrix3 R = random.rotation();
    const Vector3 t = random.vector(1);
    Shape turned = shape;
    turned.centre = R * shape.centre + t;
    turned.axes = R * shape.axes;
    const SurfacePoint before = nearestSurface(shape, p);
    const SurfacePoint after = nearestSurface(turned, R * p + t);
    EXPECT_NEAR(before.distance, after.distance, kExact);
    EXPECT_LT((R * before.normal - after.normal).norm(), 1e-9);
    EXPECT_EQ(before.face, after.face);
  }
}

TEST_P(ShapeDistance, IsTheDistanceToItsOwnFaceWhenInside) {
  for (int i = 0; i < 2000; ++i) {
    const Shape shape = next();
    const Vector3 p = shape.centre + shape.axes * random.vector(0.5);
    const SurfacePoint surface = nearestSurface(shape, p);
    if (surface.distance > 0) continue;
    const SurfacePoint face = surfaceOfFace(shape, p, surface.face);
    EXPECT_NEAR(face.distance, surface.distance, kExact);
    EXPECT_LT((face.normal - surface.normal).norm(), kExact);
  }
}

TEST_P(ShapeDistance, ScalesWithTheShapeWithoutAnyFixedLength) {
  for (int i = 0; i < 500; ++i) {
    const Shape shape = next();
    const Vector3 p = shape.centre + random.vector(1.5);
    for (const double scale : {1e-9, 1e9}) {
      Shape scaled = shape;
      scaled.centre *= scale;
      scaled.axes *= scale;
      EXPECT_NEAR(nearestSurface(scaled, scale * p).distance / scale, nearestSurface(shape, p).distance, kExact);
    }
  }
}

TEST_P(ShapeDistance, StaysInsideItsBoundsAndFillsThem) {
  for (int i = 0; i < 100; ++i) {
    const Shape shape = next();
    const Bounds bounds = boundsOf(shape);
    Vector3 low = shape.centre;
    Vector3 high = shape.centre;
    for (int j = 0; j < 2000; ++j) {
      const Vector3 p = random.onSurface(shape);
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const double size = (bounds.high - bounds.low).norm();
    EXPECT_TRUE((low.array() >= bounds.low.array() - kExact).all());
    EXPECT_TRUE((high.array() <= bounds.high.array() + kExact).all());
    // 2000 samples miss a corner by a tenth or so; a cone's bounds are those of its cylinder.
    if (shape.kind != Shape::Kind::cone) {
      EXPECT_LT((high - low - bounds.high + bounds.low).norm(), 0.25 * size);
    }
  }
}

TEST_P(ShapeDistance, IsFiniteAndNeverInsideWhereTheShapeHasNoVolume) {
  for (int i = 0; i < 2000; ++i) {
    Shape shape = next();
    const int flat = 1 + i % 7;  // which of the axes are nothing
    for (int axis = 0; axis < 3; ++axis) {
      const bool round = shape.kind != Shape::Kind::box && axis == 2;
      if (flat & (1 << (round || shape.kind == Shape::Kind::sphere ? 0 : axis))) shape.axes.col(axis).setZero();
    }
    if (shape.kind != Shape::Kind::box && shape.axes.col(0).norm() > 0 && shape.axes.col(1).norm() > 0) continue;
    const Vector3 own = random.onSurface(shape);
    for (const Vector3& p : {Vector3(shape.centre + random.vector(1)), shape.centre, own}) {
      const SurfacePoint surface = nearestSurface(shape, p);
      ASSERT_TRUE(std::isfinite(surface.distance) && surface.normal.allFinite());
      EXPECT_NEAR(surface.normal.norm(), 1, kExact);
      EXPECT_GE(surface.distance, -kExact);
      EXPECT_LE(surface.distance, (p - own).norm() + kExact);
      EXPECT_TRUE(surfaceOfFace(shape, p, surface.face).normal.allFinite());
    }
  }
}

TEST_P(ShapeDistance, IsFiniteForEnormousAndForTinyShapes) {
  for (const double scale : {1e-300, 1e-170, 1e170, 1e300}) {
    for (int i = 0; i < 100; ++i) {
      Shape shape = next();
      shape.axes *= scale;
      const SurfacePoint surface = nearestSurface(shape, random.vector(scale));
      EXPECT_TRUE(std::isfinite(surface.distance) && surface.normal.allFinite());
    }
  }
}

std::string kindName(const ::testing::TestParamInfo<int>& info) {
  constexpr std::array<const char*, 5> kNames = {"box", "sphere", "cylinder", "cone", "skewedBox"};
  return kNames[static_cast<std::size_t>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(EveryKind, ShapeDistance, ::testing::Range(0, 5), kindName);

TEST(ShapeDistanceOfABox, NamesTheFaces) {
  Shape shape;
  shape.axes = Vector3(1, 2, 3).asDiagonal();
  const std::array<Vector3, 6> beyond = {Vector3(2, 0, 0),  Vector3(-2, 0, 0), Vector3(0, 3, 0),
                                         Vector3(0, -3, 0), Vector3(0, 0, 4),  Vector3(0, 0, -4)};
  for (int face = 0; face < 6; ++face) {
    const SurfacePoint surface = nearestSurface(shape, beyond[static_cast<std::size_t>(face)]);
    EXPECT_EQ(surface.face, face);
    EXPECT_DOUBLE_EQ(surface.distance, 1);
  }
}

TEST(ShapeDistanceOfABox, IsThatOfTheFlatSheetItIsWhenTwoEdgesAreParallel) {
  Shape shape;
  shape.axes << 1, 0.5, 0, 0, 0, 1, 0, 0, 0;  // |x| <= 1.5, |y| <= 1, z = 0
  EXPECT_NEAR(nearestSurface(shape, {1.4, 0.2, 0.3}).distance, 0.3, kExact);
  EXPECT_NEAR(nearestSurface(shape, {-1.4, 0.2, -0.3}).distance, 0.3, kExact);
  EXPECT_NEAR(nearestSurface(shape, {2.5, 0, 0}).distance, 1, kExact);
}

}  // namespace
}  // namespace haptiv
