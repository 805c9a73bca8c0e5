#pragma once

#include <Inventor/SbMatrix.h>
#include <Inventor/SbVec3f.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "haptics/meshes/TriangleMesh.h"

namespace haptiv {

/// The triangles of one shape as Coin hands them over, brought into W in double precision.
class TriangleSoup {
 public:
  /// @param toW        from the shape's coordinates, Coin's way (row vectors)
  /// @param clockwise  corners come clockwise, seen from outside, before `toW`, which may mirror
  TriangleSoup(const SbMatrix& toW, bool clockwise);

  void add(const SbVec3f& a, const SbVec3f& b, const SbVec3f& c);
  std::size_t size() const { return corners_.size() / 3; }
  bool isFinite() const;
  /// As makeTriangleMesh; null where no triangle has an area. The soup is empty afterwards.
  std::shared_ptr<const TriangleMesh> makeMesh();

 private:
  Vector3 placed(const SbVec3f& p) const;

  double m_[4][4];
  bool turned_;
  std::vector<Vector3> corners_;  // three each
};

}  // namespace haptiv
