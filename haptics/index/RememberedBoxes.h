#pragma once

#include <algorithm>
#include <array>
#include <optional>

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
    Vector3 way = Vector3::Zero();  ///< that whoever asks is about to go; as much of it as there is room for [m]
  };

  /// Calls visit(item) for the boxes nearer to p_W than `reach` along every axis.
  /// @param remembered  is called with the items that are remembered anew: they will be asked for
  template <typename Visit, typename Remembered>
  void forEachNear(const BoundingTree& tree, const Vector3& p_W, double reach, const Ahead& ahead, Visit&& visit,
                   Remembered&& remembered) noexcept {
    const FloatBox query = tree.around(p_W, reach);
    if (!known_.holds(query) && ahead.margin > 0) {
      remember(tree, tree.along(p_W, p_W + ahead.way, reach + ahead.margin));
      if (!nodes_) remember(tree, tree.around(p_W, reach + ahead.margin));
      forEachRemembered(remembered);
    }
    if (!nodes_ || !known_.holds(query)) return tree.forEachNear(query, visit);
    findRemembered(query);
    for (std::size_t i = 0; i < founds_; ++i) visit(found_[i]);
  }
  template <typename Visit>
  void forEachNear(const BoundingTree& tree, const Vector3& p_W, double reach, const Ahead& ahead,
                   Visit&& visit) noexcept {
    forEachNear(tree, p_W, reach, ahead, visit, [](std::uint32_t) {});
  }

 private:
  static constexpr std::size_t kMost = 8;
  using Items = std::array<std::uint32_t, kMost * BoxNode::kWidth>;

  void remember(const BoundingTree& tree, const FloatBox& place) noexcept {
    known_ = place;
    nodes_ = tree.copyNear(known_, node_);
  }

  template <typename Visit>
  void forEachRemembered(Visit&& visit) const noexcept {
    for (std::size_t i = 0; i < nodes_.value_or(0); ++i) {
      for (const std::uint32_t child : node_[i].child) {
        if (child != BoxNode::kNone) visit(child & ~BoxNode::kItemFlag);
      }
    }
  }

  /// Mostly the same ones as the last time: then nothing is written, and who reads them need not wait until it is
  /// known.
  void findRemembered(const FloatBox& query) noexcept {
    Items found;
    std::size_t founds = 0;
    for (std::size_t i = 0; i < *nodes_; ++i) {
      const unsigned bits = node_[i].touching(query);
      for (std::size_t k = 0; k < BoxNode::kWidth; ++k) {  // without a branch: what is touched cannot be foreseen
        found[founds] = node_[i].child[k] & ~BoxNode::kItemFlag;
        founds += bits >> k & 1;
      }
    }
    if (std::equal(found.begin(), found.begin() + founds, found_.begin(), found_.begin() + founds_)) return;
    std::copy(found.begin(), found.begin() + founds, found_.begin());
    founds_ = founds;
  }

  FloatBox known_{{1, 1, 1}, {-1, -1, -1}};  ///< all boxes that touch it are in node_; at first, none
  std::optional<std::size_t> nodes_;         ///< so many; nothing where the boxes are too many to be remembered
  std::array<BoxNode, kMost> node_{};
  Items found_{};
  std::size_t founds_ = 0;
};

}  // namespace haptiv
