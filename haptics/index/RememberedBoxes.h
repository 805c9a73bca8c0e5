#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <optional>
#include <span>

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

  /// The items whose boxes are nearer to p_W than `reach` along every axis, by rising number; nothing where they are
  /// not remembered: then the tree has to be asked.
  /// @param keeper  tells what to remember (`ahead()`, asked for only where there is need) and which number an item
  /// has,
  ///                and is told which items are remembered anew (`gathered(item)`)
  template <typename Keeper>
  std::optional<std::span<const std::uint32_t>> near(const BoundingTree& tree, const Vector3& p_W, double reach,
                                                     const Keeper& keeper) noexcept {
    const FloatBox query = tree.around(p_W, reach);
    const bool isInner = inner_.holds(query);
    if (!isInner && !isKnown(query) && !findAnew(tree, query, keeper)) return std::nullopt;
    const std::uint32_t near = known().touching(query);
    const bool isNew = near != near_;
    if (isNew) list(near, keeper);
    const std::span items(item_.data(), items_);
    if (!isInner && !((isNew || items_ > kFew) && leisure_.holds(query))) lookAhead(tree, query, keeper);
    return items;
  }

 private:
  static constexpr std::size_t kNodesAtOnce = 1;  ///< of the tree, in a call
  static constexpr std::size_t kFew = 2;          ///< boxes; a call that finds more looks ahead only where it has to

  const GatheredBoxes& known() const noexcept { return gathered_[now_]; }
  bool isKnown(const FloatBox& query) const noexcept { return known().fits() && known().place().holds(query); }

  /// Whether what is around could be remembered, at once.
  template <typename Keeper>
  [[gnu::noinline]] bool findAnew(const BoundingTree& tree, const FloatBox& query, const Keeper& keeper) noexcept {
    constexpr std::size_t kAllNodes = std::numeric_limits<std::size_t>::max();
    const bool isTooMuch = known().place().holds(query);
    const Ahead ahead = keeper.ahead();
    if (isTooMuch || !(ahead.margin > 0)) return false;
    const GatheredBoxes& next = gathered_[1 - now_];
    if (next.isComplete() || !next.place().holds(query)) begin(tree, query, ahead);
    goOn(tree, query, ahead, kAllNodes, keeper);
    return isKnown(query);
  }

  /// Gathers a little of what lies ahead.
  template <typename Keeper>
  [[gnu::noinline]] void lookAhead(const BoundingTree& tree, const FloatBox& query, const Keeper& keeper) noexcept {
    if (inner_.holds(query)) return;  // found anew in this call
    const Ahead ahead = keeper.ahead();
    if (!(ahead.margin > 0)) return;
    if (gathered_[1 - now_].isComplete()) begin(tree, query, ahead);
    goOn(tree, query, ahead, kNodesAtOnce, keeper);
  }

  /// Where all is gathered, it is what is known from the next call on.
  template <typename Keeper>
  void goOn(const BoundingTree& tree, const FloatBox& query, const Ahead& ahead, std::size_t nodes,
            const Keeper& keeper) noexcept {
    const auto gathered = [&](std::uint32_t item) { keeper.gathered(item); };
    GatheredBoxes& next = gathered_[1 - now_];
    next.goOn(tree, nodes, gathered);
    if (next.isComplete() && !next.fits() && !isSmall_) {
      begin(tree, query, {ahead.margin});
      next.goOn(tree, nodes, gathered);
    }
    if (!next.isComplete()) return;
    now_ = 1 - now_;
    inner_ = known().fits() ? innerNext_ : FloatBox::nowhere();
    leisure_ = known().fits() ? leisureNext_ : FloatBox::nowhere();
    near_ = 0;
    items_ = 0;
  }

  void begin(const BoundingTree& tree, const FloatBox& query, const Ahead& ahead) noexcept {
    constexpr double kInner = 0.5, kLeisure = 0.875;
    gathered_[1 - now_].start(tree, query.reaching(ahead.way, ahead.margin));
    innerNext_ = query.reaching(kInner * ahead.way, kInner * ahead.margin);
    leisureNext_ = query.reaching(kLeisure * ahead.way, kLeisure * ahead.margin);
    isSmall_ = ahead.way.isZero(0);
  }

  /// In most calls they are the same ones as in the last.
  template <typename Keeper>
  void list(std::uint32_t near, const Keeper& keeper) noexcept {
    near_ = near;
    items_ = 0;
    for (; near != 0; near &= near - 1) {
      const std::uint32_t item = known().item(static_cast<std::size_t>(std::countr_zero(near)));
      const std::uint32_t number = keeper.number(item);
      std::size_t at = items_++;
      for (; at > 0 && keeper.number(item_[at - 1]) > number; --at) item_[at] = item_[at - 1];
      item_[at] = item;
    }
  }

  FloatBox inner_ = FloatBox::nowhere();  ///< while a query is within it, there is nothing to gather
  FloatBox innerNext_ = FloatBox::nowhere();
  FloatBox leisure_ = FloatBox::nowhere();  ///< while it is within this one, it may wait
  FloatBox leisureNext_ = FloatBox::nowhere();
  std::array<GatheredBoxes, 2> gathered_;
  std::size_t now_ = 0;     ///< which is known; the other one is gathered, until it is complete and takes its place
  bool isSmall_ = false;    ///< what is gathered is around a place, and not on a way
  std::uint32_t near_ = 0;  ///< a bit for each box that is known: those that were near in the last call ...
  std::array<std::uint32_t, GatheredBoxes::kMost * BoxNode::kWidth> item_{};  ///< ... and their items
  std::size_t items_ = 0;
};

}  // namespace haptiv
