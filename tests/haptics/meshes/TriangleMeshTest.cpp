#include "haptics/meshes/TriangleMesh.h"

#include <gtest/gtest.h>

#include <limits>

#include "haptics/meshes/Orientation.h"
#include "tests/haptics/RandomShapes.h"
#include "tests/haptics/meshes/SampleMeshes.h"

namespace haptiv {
namespace {

using testing::boxSoup;
using testing::plateSoup;
using testing::RandomShapes;
using testing::Soup;
using testing::sphereSoup;

const double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(TriangleMesh, MakesOneVertexOfCornersOnOneSpot) {
  const auto mesh = boxSoup(Vector3::Zero(), Matrix3::Identity()).mesh();
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->vertices.size(), 8u);
  EXPECT_EQ(mesh->triangles.size(), 12u);
  EXPECT_TRUE(mesh->closed);
}

TEST(TriangleMesh, WeldsWhatIsApartByRoundingAtAnySizeAndPlace) {
  RandomShapes random(1);
  for (const double scale : {1e-3, 1.0, 1e3}) {
    for (const double away : {0.0, 30.0}) {
      Soup soup = sphereSoup(scale, 20);
      for (Vector3& p : soup.vertices) {
        p += scale * Vector3(away, -away, 2 * away);
        p = p.cast<float>().cast<double>().eval() + 1e-7 * scale * random.vector(1);
      }
      const auto mesh = soup.mesh();
      ASSERT_TRUE(mesh);
      EXPECT_EQ(mesh->vertices.size(), 40u * 19u + 2u) << scale << " " << away;
      EXPECT_EQ(mesh->triangles.size(), 2u * 40u * 19u);
      EXPECT_TRUE(mesh->closed);
    }
  }
}

TEST(TriangleMesh, IsOpenWhereATriangleIsMissingOrTurned) {
  Soup soup = boxSoup(Vector3::Zero(), Matrix3::Identity(), 3);
  Soup turned = soup;
  std::swap(turned.triangles[7][0], turned.triangles[7][1]);
  EXPECT_FALSE(turned.mesh()->closed);
  soup.triangles.erase(soup.triangles.begin() + 11);
  EXPECT_FALSE(soup.mesh()->closed);
  EXPECT_FALSE(plateSoup(1).mesh()->closed);
}

TEST(TriangleMesh, IsOpenWhereItHasNoVolume) {
  Soup soup = plateSoup(1, 2);
  const Soup front = soup;
  for (std::size_t i = 0; i + 2 < front.vertices.size(); i += 3)
    soup.add(front.vertices[i + 2], front.vertices[i + 1], front.vertices[i]);
  EXPECT_FALSE(soup.mesh()->closed);
}

TEST(TriangleMesh, TurnsAClosedMeshThatFacesInwards) {
  Soup soup = sphereSoup(0.3, 8);
  for (TriangleMesh::Triangle& triangle : soup.triangles) std::swap(triangle[0], triangle[1]);
  const auto mesh = soup.mesh();
  EXPECT_TRUE(mesh->closed);
  EXPECT_GT(volumeWithin(mesh->vertices, mesh->triangles), 0);
}

TEST(TriangleMesh, KnowsTheVolumeOfABoxAnywhere) {
  RandomShapes random(2);
  for (int i = 0; i < 20; ++i) {
    const Shape box = random.skewedBox();
    const auto mesh = boxSoup(box.centre, box.axes, 2).mesh();
    EXPECT_NEAR(volumeWithin(mesh->vertices, mesh->triangles), 8 * std::abs(box.axes.determinant()), 1e-9);
  }
}

TEST(TriangleMesh, DropsWhatIsNoTriangle) {
  Soup soup = plateSoup(1);
  soup.add({0, 0, 0}, {0, 0, 0}, {1, 0, 0});
  soup.add({0, 0, 1}, {0, kNaN, 0}, {1, 0, 0});
  soup.add({0, 0, 1}, {0, 1e200, 0}, {1, 0, 0});
  soup.triangles.push_back({0, 1, 4000000000U});
  const auto mesh = soup.mesh();
  EXPECT_EQ(mesh->triangles.size(), 2u);
  EXPECT_EQ(mesh->vertices.size(), 4u);
  EXPECT_EQ(makeTriangleMesh({}, {}), nullptr);
  EXPECT_EQ(makeTriangleMesh({{1, 2, 3}, {1, 2, 3}}, {{0, 1, 1}}), nullptr);
}

TEST(TriangleMesh, IsTheSameTwiceAndWhenRestored) {
  const Soup soup = sphereSoup(1, 12);
  const auto mesh = soup.mesh(), again = soup.mesh();
  EXPECT_EQ(mesh->vertices, again->vertices);
  EXPECT_EQ(mesh->triangles, again->triangles);
  const auto restored = restoreTriangleMesh(mesh->vertices, mesh->triangles);
  EXPECT_EQ(restored->vertices, mesh->vertices);
  EXPECT_EQ(restored->triangles, mesh->triangles);
  EXPECT_EQ(restored->closed, mesh->closed);
}

/// A cluster of vertices next to one that is far away: all of it is within a few tolerances.
TEST(TriangleMesh, TakesVerticesThatCrowdOneSpot) {
  RandomShapes random(3);
  Soup soup;
  for (int i = 0; i < 50000; ++i)
    soup.add(random.vector(1e-6), random.vector(1e-6), i == 0 ? Vector3(1, 0, 0) : random.vector(1e-6));
  const auto mesh = soup.mesh();
  ASSERT_TRUE(mesh);
  EXPECT_LT(mesh->vertices.size(), 1000u);
}

}  // namespace
}  // namespace haptiv
