#include "haptics/meshes/MeshDistance.h"

#include <gtest/gtest.h>

#include "haptics/meshes/TrianglePoint.h"
#include "tests/haptics/RandomShapes.h"
#include "tests/haptics/meshes/SampleMeshes.h"

namespace haptiv {
namespace {

using testing::boxSoup;
using testing::plateSoup;
using testing::RandomShapes;
using testing::Soup;
using testing::sphereSoup;

/// The nearest of many points of the triangle can only be a little farther than the nearest point.
TEST(ClosestOnTriangle, IsOnTheTriangleAndNearerThanAnyOfItsPoints) {
  RandomShapes random(1);
  for (int run = 0; run < 2000; ++run) {
    const Vector3 a = random.vector(1), b = random.vector(1);
    const Vector3 c = run % 4 == 0 ? Vector3(a + 1e-6 * random.vector(1)) : random.vector(1);  // needles among them
    const Vector3 p = random.vector(2);
    const double distance = (closestOnTriangle(p, a, b, c) - p).norm();
    for (int i = 0; i < 50; ++i) {
      double u = random.between(0, 1), v = random.between(0, 1);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      EXPECT_LE(distance, (a + u * (b - a) + v * (c - a) - p).norm() + 1e-12);
    }
    const Vector3 again = closestOnTriangle(closestOnTriangle(p, a, b, c), a, b, c);
    EXPECT_LT((again - closestOnTriangle(p, a, b, c)).norm(), 1e-7);  // needles are a millionth wide
  }
}

TEST(ClosestOnTriangle, TakesTrianglesThatAreLinesOrPoints) {
  const Vector3 p(1, 2, 3), o = Vector3::Zero(), x = Vector3::UnitX();
  EXPECT_EQ(closestOnTriangle(p, o, o, o), o);
  EXPECT_LT((closestOnTriangle(p, o, 4 * x, 2 * x) - x).norm(), 1e-12);
  EXPECT_LT((closestOnTriangle(p, o, o, 4 * x) - x).norm(), 1e-12);
  EXPECT_LT((closestOnTriangle(p, 4 * x, o, o) - x).norm(), 1e-12);
}

TEST(MeshDistance, IsTheBoxsForABoxOfTriangles) {
  RandomShapes random(2);
  for (int run = 0; run < 30; ++run) {
    Shape box = run % 2 == 0 ? random.shape(Shape::Kind::box) : random.skewedBox();
    const auto mesh = boxSoup(box.centre, box.axes, 1 + run % 4).mesh();
    ASSERT_TRUE(mesh->closed);
    for (int i = 0; i < 200; ++i) {
      const Vector3 p =
          i % 2 == 0 ? Vector3(box.centre + random.vector(2)) : Vector3(box.centre + box.axes * random.vector(1.1));
      const SurfacePoint exact = nearestSurface(box, p), triangles = nearestOnMesh(*mesh, p);
      EXPECT_NEAR(triangles.distance, exact.distance, 1e-9);
      // Where two faces are equally near, either may be named.
      if (exact.distance > 1e-6) {
        EXPECT_LT((triangles.normal - exact.normal).norm(), 1e-6);
      }
    }
  }
}

/// Points above edges and corners are nearest to triangles that alone would call them inside.
TEST(MeshDistance, KnowsInsideFromOutsideOnSharpSpikes) {
  RandomShapes random(3);
  for (int run = 0; run < 200; ++run) {
    Soup soup;  // a tetrahedron, pressed flat
    const Vector3 a = random.vector(1), b = random.vector(1), c = random.vector(1);
    const Vector3 d = (a + b + c) / 3 + 0.02 * random.direction() + random.vector(0.3);
    soup.add(a, b, c), soup.add(a, c, d), soup.add(a, d, b), soup.add(b, d, c);
    const auto mesh = soup.mesh();
    ASSERT_TRUE(mesh);
    if (!mesh->closed) continue;
    Matrix3 sides;
    sides << b - a, c - a, d - a;
    for (int i = 0; i < 100; ++i) {
      const Vector3 p = (a + b + c + d) / 4 + random.vector(1);
      const Vector3 s = sides.inverse() * (p - a);
      const bool isInside = s.minCoeff() > 0 && s.sum() < 1;
      EXPECT_EQ(nearestOnMesh(*mesh, p).distance < 0, isInside);
    }
  }
}

TEST(MeshDistance, LooksAtAnOpenMeshFromBothSides) {
  const auto plate = plateSoup(1, 3).mesh();
  for (const double side : {-1.0, 1.0}) {
    const SurfacePoint point = nearestOnMesh(*plate, {0.1, 0.2, 0.3 * side});
    EXPECT_NEAR(point.distance, 0.3, 1e-12);
    EXPECT_LT((point.normal - side * Vector3::UnitZ()).norm(), 1e-12);
  }
}

TEST(MeshDistance, IsFiniteOnTheMeshItself) {
  RandomShapes random(4);
  const auto mesh = sphereSoup(0.2, 6).mesh();
  for (const Vector3& vertex : mesh->vertices) {
    const SurfacePoint point = nearestOnMesh(*mesh, vertex);
    EXPECT_NEAR(point.distance, 0, 1e-12);
    EXPECT_NEAR(point.normal.norm(), 1, 1e-12);
    EXPECT_GT(point.normal.dot(vertex), 0);
  }
}

TEST(MeshDistance, OfNoMeshIsFar) {
  Shape shape;
  shape.kind = Shape::Kind::mesh;
  EXPECT_GT(nearestSurface(shape, Vector3::Zero()).distance, 1e300);
  EXPECT_GT(nearestOnMesh({}, Vector3::Zero()).distance, 1e300);
  EXPECT_GT(surfaceOfFace(shape, Vector3::Zero(), 3).distance, 1e300);
}

}  // namespace
}  // namespace haptiv
