#include "scenegraph/compiling/meshes/TriangleSoup.h"

#include <algorithm>
#include <utility>

namespace haptiv {

TriangleSoup::TriangleSoup(const SbMatrix& toW, bool clockwise) : turned_(clockwise != (toW.det3() < 0)) {
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) m_[row][column] = toW[row][column];
  }
}

Vector3 TriangleSoup::placed(const SbVec3f& p) const {
  const float* x = p.getValue();
  const auto column = [&](int i) { return x[0] * m_[0][i] + x[1] * m_[1][i] + x[2] * m_[2][i] + m_[3][i]; };
  return Vector3(column(0), column(1), column(2)) / column(3);
}

void TriangleSoup::add(const SbVec3f& a, const SbVec3f& b, const SbVec3f& c) {
  corners_.push_back(placed(a));
  corners_.push_back(placed(turned_ ? c : b));
  corners_.push_back(placed(turned_ ? b : c));
}

bool TriangleSoup::isFinite() const {
  return std::ranges::all_of(corners_, [](const Vector3& corner) { return corner.allFinite(); });
}

std::shared_ptr<const TriangleMesh> TriangleSoup::makeMesh() {
  const std::vector<Vector3> corners = std::exchange(corners_, {});
  std::vector<TriangleMesh::Triangle> triangles(corners.size() / 3);
  for (std::uint32_t i = 0; i < triangles.size(); ++i) triangles[i] = {3 * i, 3 * i + 1, 3 * i + 2};
  return makeTriangleMesh(corners, triangles);
}

}  // namespace haptiv
