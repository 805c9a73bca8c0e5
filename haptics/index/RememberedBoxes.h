#pragma once

#include <array>
#include <bit>

#include "haptics/index/BoundingTree.h"

namespace haptiv {

/// The boxes of a tree around a place, remembered: who asks again and again, from a little farther on each time, is
/// spared the walk down the tree.
///
/// It finds the same items as the tree, perhaps in another order. It knows one tree: whoever turns to another one has
/// to forget() first. Realtime-safe: yes.
class RememberedBoxes {
 public:
  void forget() noexcept { *this = {}; }

  /// What to remember, should the tree have to be asked.
  struct Ahead {
    double margin = 0;              ///< how much farther than asked for; 0: nothing is remembered [m]
    Vector3 way = Vector3::Zero();  ///< that whoever asks is about to go [m]
  };

  /// Calls visit(item) for the boxes nearer to p_W than `reach` along every axis.
  template <typename Visit>
  void forEachNear(const BoundingTree& tree, const Vector3& p_W, double reach, const Ahead& ahead,
                   Visit&& visit) noexcept {
    const FloatBox query = tree.around(p_W, reach);
    if (!known_.holds(query) && ahead.margin > 0) {
      const double most = 0.8 * ahead.margin;  // so that p_W itself stays well within
      known_ = tree.around(p_W + ahead.way.cwiseMax(-most).cwiseMin(most), reach + ahead.margin);
      nodes_ = tree.copyNear(known_, node_);
    }
    if (!nodes_ || !known_.holds(query)) return tree.forEachNear(query, visit);
    std::array<std::uint32_t, kMost * BoxNode::kWidth> found;
    std::size_t items = 0;
    for (std::size_t i = 0; i < *nodes_; ++i) {
      const unsigned bits = node_[i].touching(query);
      for (std::size_t k = 0; k < BoxNode::kWidth; ++k) {  // without a branch: what is touched cannot be foreseen
        found[items] = node_[i].child[k];
        items += bits >> k & 1;
      }
    }
    for (std::size_t i = 0; i < items; ++i) visit(found[i] & ~BoxNode::kItemFlag);
  }

 private:
  static constexpr std::size_t kMost = 8;

  FloatBox known_{{1, 1, 1}, {-1, -1, -1}};  ///< all boxes that touch it are in node_; at first, none
  std::optional<std::size_t> nodes_;         ///< so many; nothing where the boxes are too many to be remembered
  std::array<BoxNode, kMost> node_{};
};

}  // namespace haptiv
