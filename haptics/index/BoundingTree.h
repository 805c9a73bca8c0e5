#pragma once

#include <bit>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "haptics/index/Bounds.h"
#include "haptics/index/BuildNodes.h"
#include "haptics/index/Fetch.h"
#include "haptics/index/SweptBall.h"

namespace haptiv {

/// Finds, among very many boxes, those near a place: one flat tree, built once. The boxes are items 0, 1, ...;
/// what they bound (walls, zones, triangles) stays with whoever asks.
///
/// A query visits every item whose box it touches, and a few whose box is that near only for rounding: the visitor
/// measures for itself. What is visited, and in which order, depends on nothing but the boxes given and the query.
/// Boxes may lie on one spot, be empty, infinite or NaN (then they are near everything), and stand anywhere: all
/// tolerances are relative to the numbers themselves. The tree keeps single-precision boxes relative to its middle,
/// rounded outwards.
///
/// Queries are realtime-safe (no allocation, a stack of fixed size), and thread-safe among each other.
class BoundingTree {
 public:
  static constexpr std::size_t kMaxItems = BoxNode::kItemFlag - 1;

  BoundingTree() = default;
  /// O(n log n): half a second for a million boxes. Throws std::length_error beyond kMaxItems.
  explicit BoundingTree(std::span<const Bounds> boxes);
  /// The same, and how it came to be is put into `plan`. @param all  the box around the finite ones
  BoundingTree(std::span<const Bounds> boxes, const Bounds& all, TreePlan* plan = nullptr);
  /// Of the nodes that rebuildNodes made of boxes seen from `origin`.
  BoundingTree(std::vector<BoxNode> nodes, const Vector3& origin, std::size_t size);

  std::size_t size() const noexcept { return size_; }
  const Vector3& origin() const noexcept { return origin_; }
  std::span<const BoxNode> nodes() const noexcept { return nodes_; }
  std::size_t bytes() const noexcept { return nodes_.size() * sizeof(BoxNode); }

  /// Renames the items along the tree: from now on, item i is what was item result[i]. Who then stores what the items
  /// stand for in this order has neighbours in space next to each other in memory.
  std::vector<std::uint32_t> renumber();

  /// Calls visit(item) for the boxes nearer to p_W than `reach` along every axis.
  template <typename Visit>
  void forEachNear(const Vector3& p_W, double reach, Visit&& visit) const noexcept {
    forEachNear(around(p_W, reach), visit);
  }

  /// What is nearer to p_W than `reach` along every axis, as the nodes' boxes are seen.
  FloatBox around(const Vector3& p_W, double reach) const noexcept { return cubeAround(p_W - origin_, reach, farOff_); }

  /// The same for all along a way.
  FloatBox along(const Vector3& from_W, const Vector3& to_W, double reach) const noexcept {
    return hullOf(around(from_W, reach), around(to_W, reach));
  }

  /// The same for all that these returned.
  template <typename Visit>
  void forEachNear(const FloatBox& query, Visit&& visit) const noexcept {
    walk([&](const BoxNode& node) { return node.touching(query); }, visit);
  }

  /// Calls visit(item) for the boxes that are no farther from p_W than `reach`.
  template <typename Visit>
  void forEachWithin(const Vector3& p_W, double reach, Visit&& visit) const noexcept;

  /// Lists the items whose boxes are no farther from a box than `reach`, level by level: most of what is read of the
  /// tree is then on its way from memory at once, and nothing is guessed about what is near. Returns their number, or
  /// nothing where there are more, or where the walk is a long one.
  /// @param isListed  is called with each item as soon as it is: while the walk goes on, it may fetch what it needs
  template <typename Listed>
  std::optional<std::size_t> listWithin(const Bounds& from, double reach, std::span<std::uint32_t> items,
                                        Listed&& isListed) const noexcept;

  /// The same of some of the nodes alone; nothing where there are more.
  std::optional<std::size_t> listOf(std::span<const std::uint32_t> nodes, const Bounds& from, double reach,
                                    std::span<std::uint32_t> items) const noexcept;

  /// One bit for each box of one of the nodes that is no farther from p_W than `reach`.
  unsigned within(const BoxNode& node, const Vector3& p_W, double reach) const noexcept {
    return node.within(outwards(p_W, p_W, origin_), widened(reach));
  }

  /// Calls visit(item) for the boxes that a ball of radius `reach` may touch on the straight way from one place to
  /// another: all that it touches, and a few that are near the way.
  template <typename Visit>
  void forEachAlong(const Vector3& from_W, const Vector3& to_W, double reach, Visit&& visit) const noexcept;

  /// Calls measure(item), which returns a distance, for boxes in the order of their nearness to p_W, as long as a box
  /// is nearer than `reach` and than the smallest distance measured so far. Returns that distance, or `reach`.
  /// A distance is not negative.
  template <typename Measure>
  double nearest(const Vector3& p_W, double reach, Measure&& measure) const noexcept;

 private:
  static constexpr float kRounding = 1 - 1e-5F;                 ///< of squared distances, with room to spare
  static constexpr std::size_t kStack = 3 * kMaxTreeDepth + 1;  ///< each level takes one place and leaves four

  /// Square of a reach as BoxNode::within wants it, with room for what single precision rounds [m^2].
  static float widened(double reach) noexcept {
    return index_detail::roundedUp(std::min(reach * reach / kRounding, 0.5 * FloatBox::kFar * FloatBox::kFar));
  }

  template <typename Touching, typename Visit>
  void walk(Touching&& touching, Visit&& visit) const noexcept;

  std::vector<BoxNode> nodes_;  ///< the root first; parents before children
  Vector3 origin_ = Vector3::Zero();
  double farOff_ = 0;  ///< how large the numbers of the origin are [m]
  std::size_t size_ = 0;
};

template <typename Touching, typename Visit>
void BoundingTree::walk(Touching&& touching, Visit&& visit) const noexcept {
  if (nodes_.empty()) return;
  std::array<std::uint32_t, kStack> waiting;
  waiting[0] = 0;
  for (std::size_t count = 1; count > 0;) {
    const BoxNode& node = nodes_[waiting[--count]];
    for (unsigned bits = touching(node); bits != 0; bits &= bits - 1) {
      const std::uint32_t child = node.child[std::countr_zero(bits)];
      if ((child & BoxNode::kItemFlag) != 0) {
        visit(child & ~BoxNode::kItemFlag);
      } else {
        waiting[count++] = child;
        fetch(nodes_[child]);
      }
    }
  }
}

template <typename Listed>
std::optional<std::size_t> BoundingTree::listWithin(const Bounds& from, double reach, std::span<std::uint32_t> items,
                                                    Listed&& isListed) const noexcept {
  constexpr std::size_t kLongWalk = 128, kWidth = BoxNode::kWidth;
  std::array<std::uint32_t, kLongWalk> nodes;
  const FloatBox query = outwards(from.low, from.high, origin_);
  const float most = widened(reach);
  std::size_t listed = 0, told = 0, known = 0, fetched = 1;
  if (!nodes_.empty()) nodes[known++] = 0;
  for (std::size_t next = 0; next < known; ++next) {
    if (known + kWidth > nodes.size() || listed + kWidth > items.size()) return std::nullopt;
    const BoxNode& node = nodes_[nodes[next]];
    const unsigned bits = node.within(query, most);
    for (std::size_t k = 0; k < kWidth; ++k) {  // written in any case, and then counted or not
      const std::uint32_t child = node.child[k], isItem = child >> 31U, isNear = bits >> k & 1U;
      items[listed] = child & ~BoxNode::kItemFlag;
      listed += isNear & isItem;
      nodes[known] = child;
      known += isNear & ~isItem;
    }
    for (; told < listed; ++told) isListed(items[told]);
    for (; fetched < known; ++fetched) fetch(nodes_[nodes[fetched]]);
  }
  return listed;
}

template <typename Visit>
void BoundingTree::forEachWithin(const Vector3& p_W, double reach, Visit&& visit) const noexcept {
  const FloatBox query = outwards(p_W, p_W, origin_);
  const float most = widened(reach);
  const auto touching = [&](const BoxNode& node) { return node.within(query, most); };
  walk(touching, visit);
}

template <typename Visit>
void BoundingTree::forEachAlong(const Vector3& from_W, const Vector3& to_W, double reach,
                                Visit&& visit) const noexcept {
  const Vector3 low = from_W.cwiseMin(to_W), high = from_W.cwiseMax(to_W);
  const FloatBox query = outwards(low.array() - reach, high.array() + reach, origin_);
  const double numbers = low.cwiseAbs().maxCoeff() + high.cwiseAbs().maxCoeff() + origin_.cwiseAbs().maxCoeff();
  const SweptBall ball(from_W - origin_, to_W - origin_, reach, index_detail::kDoubleSlack * (numbers + reach));
  const auto touching = [&](const BoxNode& node) {
    unsigned kept = node.touching(query);
    for (unsigned bits = kept; bits != 0; bits &= bits - 1) {
      const int place = std::countr_zero(bits);
      if (!ball.mayTouch(node, static_cast<std::size_t>(place))) kept &= ~(1U << place);
    }
    return kept;
  };
  walk(touching, visit);
}

template <typename Measure>
double BoundingTree::nearest(const Vector3& p_W, double reach, Measure&& measure) const noexcept {
  struct Place {
    float squared;  ///< distance of the box [m^2]
    std::uint32_t child;
  };
  const FloatBox query = outwards(p_W, p_W, origin_);
  std::array<Place, kStack> waiting;  // farther ones below nearer ones, among the places of one node
  waiting[0] = {0, 0};
  double best = reach;
  for (std::size_t count = nodes_.empty() ? 0 : 1; count > 0;) {
    const Place place = waiting[--count];
    if (!(double{place.squared} * kRounding < best * best)) continue;
    if ((place.child & BoxNode::kItemFlag) != 0) {
      best = std::min(best, measure(place.child & ~BoxNode::kItemFlag));
      continue;
    }
    const BoxNode& node = nodes_[place.child];
    const std::array<float, 4> squared = node.squaredDistances(query);
    const std::size_t first = count;
    for (std::size_t i = 0; i < 4; ++i) {
      if (node.child[i] == BoxNode::kNone) continue;
      std::size_t at = count++;
      for (; at > first && waiting[at - 1].squared < squared[i]; --at) waiting[at] = waiting[at - 1];
      waiting[at] = {squared[i], node.child[i]};
    }
  }
  return best;
}

}  // namespace haptiv
