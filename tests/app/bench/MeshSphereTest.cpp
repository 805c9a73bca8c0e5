#include "app/bench/collision/MeshSphere.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace haptiv
