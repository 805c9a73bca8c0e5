#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>

#include "haptics/index/BoxNode.h"
#include "haptics/index/SweptBall.h"

namespace haptiv {

// What a tree is asked for. Each tells of a node which of its boxes are meant, one bit each. All places are seen from
// the tree's origin, rounded outwards. Realtime-safe: yes.

/// What has a point in common with a box.
struct TouchingBox {
  FloatBox box;

  unsigned operator()(const BoxNode& node) const noexcept { return node.touching(box); }
};

/// What is no farther from a place, or from a box, than a reach.
struct WithinReach {
  static constexpr float kRounding = 1 - 1e-5F;  ///< of squared distances, with room to spare

  FloatBox from;
  float most;  ///< square of the reach, with room for what single precision rounds [m^2]

  WithinReach(const Vector3& p_W, double reach, const Vector3& origin) noexcept
      : WithinReach(Bounds{p_W, p_W}, reach, origin) {}
  WithinReach(const Bounds& box_W, double reach, const Vector3& origin) noexcept
      : from(outwards(box_W.low, box_W.high, origin)),
        most(index_detail::roundedUp(std::min(reach * reach / kRounding, 0.5 * FloatBox::kFar * FloatBox::kFar))) {}

  unsigned operator()(const BoxNode& node) const noexcept { return node.within(from, most); }
};

/// What a ball of radius `reach` may touch on a straight way, and a little of what is near the way.
class AlongWay {
 public:
  AlongWay(const Vector3& from_W, const Vector3& to_W, double reach, const Vector3& origin) noexcept
      : AlongWay(from_W, to_W, from_W.cwiseMin(to_W), from_W.cwiseMax(to_W), reach, origin) {}

  unsigned operator()(const BoxNode& node) const noexcept {
    unsigned kept = node.touching(hull_);
    for (unsigned bits = kept; bits != 0; bits &= bits - 1) {
      const int place = std::countr_zero(bits);
      if (!ball_.mayTouch(node, static_cast<std::size_t>(place))) kept &= ~(1U << place);
    }
    return kept;
  }

 private:
  AlongWay(const Vector3& from_W, const Vector3& to_W, const Vector3& low, const Vector3& high, double reach,
           const Vector3& origin) noexcept
      : hull_(outwards(low.array() - reach, high.array() + reach, origin)),
        ball_(from_W - origin, to_W - origin, reach,
              index_detail::kDoubleSlack *
                  (low.cwiseAbs().maxCoeff() + high.cwiseAbs().maxCoeff() + origin.cwiseAbs().maxCoeff() + reach)) {}

  FloatBox hull_;
  SweptBall ball_;
};

}  // namespace haptiv
