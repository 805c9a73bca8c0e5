#include "app/bench/scenes/MeshSphere.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace haptiv {
namespace {

TEST(MeshSphere, IsOneClosedMeshOfAtLeastSoManyTriangles) {
  const HapticScene scene = meshSphere(5000);
  const TriangleMesh& mesh = *scene.walls.at(0).shape.mesh;
  EXPECT_GE(mesh.triangles.size(), 5000u);
  EXPECT_LT(mesh.triangles.size(), 5500u);
  EXPECT_TRUE(mesh.closed);
  EXPECT_EQ(mesh.vertices.size(), mesh.triangles.size() / 2 + 2);  // Euler: of a sphere, and welded
  for (const Vector3& vertex : mesh.vertices) EXPECT_NEAR(vertex.norm(), kSphereRadius, 1e-12);
}

TEST(MeshSphere, IsPassedOutsideAndWithoutJumps) {
  const std::vector<ToolMotion> path = pathOverSphere(5);
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_LT((path[i].position - path[i - 1].position).norm(), kSphereToolRadius);
    EXPECT_GT(path[i].position.norm(), kSphereRadius);
  }
}

/// The middles of so large triangles lie below the sphere by up to a ten-thousandth of its radius.
TEST(MeshSphere, IsFeltInEveryTickAndAsHardAsTheSphereAtAnyScale) {
  for (const double scale : {0.1, 1.0, 10.0}) {
    const HapticScene scene = meshSphere(100000, scale);
    ContactSet contacts;
    int inContact = 0, missed = 0, imagined = 0;
    double peak = 0, analyticPeak = 0;
    for (ToolMotion tool : pathOverSphere(5, scale)) {
      tool.velocity.setZero();
      const double depth = scale * kSphereRadius + tool.radius - tool.position.norm();
      peak = std::max(peak, renderWalls(scene, tool, contacts).norm());
      analyticPeak = std::max(analyticPeak, scene.walls[0].surface.stiffness * depth);
      if (depth > 1e-5 * scale) ++inContact;
      if (depth > 1e-5 * scale && contacts.count == 0) ++missed;
      if (depth < 0 && contacts.count > 0) ++imagined;
    }
    EXPECT_GT(inContact, 4000);
    EXPECT_EQ(missed, 0) << "size x" << scale;
    EXPECT_EQ(imagined, 0) << "size x" << scale;
    EXPECT_NEAR(peak, analyticPeak, 0.05 * analyticPeak);
  }
}

}  // namespace
}  // namespace haptiv
