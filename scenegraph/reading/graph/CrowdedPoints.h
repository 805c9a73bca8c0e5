#pragma once

#include <Inventor/fields/SoMFInt32.h>

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

 private:
  std::unordered_set<const SoNode*> counted_;
  double work_ = 0;  ///< sum over the points of the squares of their corners
};

}  // namespace haptiv
