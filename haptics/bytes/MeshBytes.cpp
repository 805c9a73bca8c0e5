#include "haptics/bytes/MeshBytes.h"

#include <utility>

namespace haptiv {

void write(ByteWriter& out, const TriangleMesh& mesh) {
  out.u32(static_cast<std::uint32_t>(mesh.vertices.size()));
  for (const Vector3& vertex : mesh.vertices) out.matrix(vertex);
  out.u32(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) out.u32(corner);
  }
}

std::shared_ptr<const TriangleMesh> readMesh(ByteReader& in) {
  std::vector<Vector3> vertices(in.count(3 * 8));
  for (Vector3& vertex : vertices) {
    in.matrix(vertex);
    if (vertex.cwiseAbs().maxCoeff() > TriangleMesh::kFar) in.fail("a vertex too far away to be felt");
  }
  std::vector<TriangleMesh::Triangle> triangles(in.count(3 * 4));
  for (TriangleMesh::Triangle& triangle : triangles) {
    for (std::uint32_t& corner : triangle) {
      corner = in.u32();
      if (corner >= vertices.size()) in.fail("a triangle of vertices that are not there");
    }
  }
  if (triangles.empty()) in.fail("a mesh without triangles");
  return restoreTriangleMesh(std::move(vertices), std::move(triangles));
}

}  // namespace haptiv
