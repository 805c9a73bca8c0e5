#pragma once

#include <Inventor/fields/SoMFInt32.h>
#include <Inventor/fields/SoMFVec3f.h>

#include <cstdint>
#include <string>
#include <unordered_set>

class SoNode;

namespace haptiv {

/// Coin makes the normals of faces in a time that grows with the square of how many corners lie on one point: of a
/// scene's shapes together that must come to some seconds at most.
class CrowdedPoints {
 public:
  /// Counts a shape, once; its indices are known to be within its coordinates. Why it is too much, with all before it;
  /// empty where it is not.
  std::string add(const SoNode* shape, const SoMFInt32& coordIndex);
  /// The same of a shape without indices, whose corners are on one point where their coordinates are the same.
  /// @param first, count  of `points`, which has them
  std::string add(const SoNode* shape, const SoMFVec3f& points, std::int64_t first, std::int64_t count);

 private:
  void take(std::size_t corners);
  std::string fault() const;

  std::unordered_set<const SoNode*> counted_;
  double work_ = 0;       ///< sum over the points of the squares of their corners ...
  std::size_t most_ = 0;  ///< ... and how many the most crowded one has, of the shape that is being counted
};

}  // namespace haptiv
