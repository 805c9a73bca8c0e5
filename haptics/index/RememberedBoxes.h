#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "haptics/index/GatheredBoxes.h"

namespace haptiv {

/// The boxes of a tree around a place, remembered: who asks again and again, from a little farther on each time, is
/// spared the walk down the tree. Where the edge of what is remembered comes near, what lies ahead is gathered, a
/// little in each call, so that no call takes long.
///
/// It finds the same items as the tree, perhaps in another order. It knows one tree: whoever turns to another one has
/// to forget() first. Realtime-safe: yes.
class RememberedBoxes {
 public:
  void forget() noexcept { *this = {}; }

  /// What to remember, should there be need.
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
    const bool isKnown = inner_.holds(query) || lookAhead(tree, query, p_W, reach, ahead, remembered);
    if (!isKnown) return tree.forEachNear(query, visit);
    findRemembered(query);
    for (std::size_t i = 0; i < founds_; ++i) visit(found_[i]);
  }
  template <typename Visit>
  void forEachNear(const BoundingTree& tree, const Vector3& p_W, double reach, const Ahead& ahead,
                   Visit&& visit) noexcept {
    forEachNear(tree, p_W, reach, ahead, visit, [](std::uint32_t) {});
  }

 private:
  static constexpr std::size_t kNodesAtOnce = 1;  ///< of the tree, in a call
  using Items = std::array<std::uint32_t, GatheredBoxes::kMost * BoxNode::kWidth>;

  const GatheredBoxes& known() const noexcept { return gathered_[now_]; }

  /// Gathers what lies ahead, and returns whether the query is within what is known now.
  template <typename Remembered>
  [[gnu::noinline]] bool lookAhead(const BoundingTree& tree, const FloatBox& query, const Vector3& p_W, double reach,
                                   const Ahead& ahead, Remembered&& remembered) noexcept {
    const bool isInside = known().place().holds(query);
    const bool isTooMuch = isInside && !known().fits();
    if (ahead.margin > 0 && !isTooMuch) gather(tree, query, isInside, p_W, reach, ahead, remembered);
    return known().fits() && known().place().holds(query);
  }

  /// A little of what lies ahead, or where the query is outside of what is known, all.
  template <typename Remembered>
  void gather(const BoundingTree& tree, const FloatBox& query, bool isInside, const Vector3& p_W, double reach,
              const Ahead& ahead, Remembered&& remembered) noexcept {
    const std::size_t nodes = isInside ? kNodesAtOnce : std::numeric_limits<std::size_t>::max();
    GatheredBoxes& next = gathered_[1 - now_];
    if (next.isComplete() || !(isInside || next.place().holds(query))) begin(tree, p_W, reach, ahead);
    next.goOn(tree, nodes, remembered);
    if (next.isComplete() && !next.fits() && !isSmall_) {
      begin(tree, p_W, reach, {ahead.margin});
      next.goOn(tree, nodes, remembered);
    }
    if (!next.isComplete()) return;
    now_ = 1 - now_;
    inner_ = known().fits() ? innerNext_ : FloatBox::nowhere();
  }

  void begin(const BoundingTree& tree, const Vector3& p_W, double reach, const Ahead& ahead) noexcept {
    constexpr double kInner = 0.75;
    gathered_[1 - now_].start(tree, tree.along(p_W, p_W + ahead.way, reach + ahead.margin));
    innerNext_ = tree.along(p_W, p_W + kInner * ahead.way, reach + kInner * ahead.margin);
    isSmall_ = ahead.way.isZero(0);
  }

  /// Mostly the same ones as the last time: then nothing is written, and who reads them need not wait until it is
  /// known.
  void findRemembered(const FloatBox& query) noexcept {
    Items found;
    std::size_t founds = 0;
    for (const BoxNode& node : known().nodes()) {
      const unsigned bits = node.touching(query);
      for (std::size_t k = 0; k < BoxNode::kWidth; ++k) {  // without a branch: what is touched cannot be foreseen
        found[founds] = node.child[k] & ~BoxNode::kItemFlag;
        founds += bits >> k & 1;
      }
    }
    bool isSame = founds == founds_;
    for (std::size_t i = 0; isSame && i < founds; ++i) isSame = found[i] == found_[i];
    if (isSame) return;
    std::copy(found.begin(), found.begin() + founds, found_.begin());
    founds_ = founds;
  }

  FloatBox inner_ = FloatBox::nowhere();  ///< while a query is within it, there is nothing to gather
  FloatBox innerNext_ = FloatBox::nowhere();
  std::array<GatheredBoxes, 2> gathered_;
  std::size_t now_ =
      0;  ///< which of them is known; the other one is gathered, until it is complete and takes its place
  bool isSmall_ = false;  ///< what is gathered is around a place, and not on a way
  Items found_{};
  std::size_t founds_ = 0;
};

}  // namespace haptiv
