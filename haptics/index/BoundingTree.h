#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "haptics/geometry/Bounds.h"
#include "haptics/index/BuildNodes.h"
#include "haptics/index/NodeQueries.h"
#include "haptics/index/TreeListing.h"
#include "haptics/index/TreeSearch.h"
#include "haptics/index/TreeWalk.h"

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

  /// What is nearer to p_W than `reach` along every axis, as the nodes' boxes are seen.
  FloatBox around(const Vector3& p_W, double reach) const noexcept { return cubeAround(p_W - origin_, reach, farOff_); }

  /// Calls visit(item) for the boxes that have a point in common with what this returned.
  template <typename Visit>
  void forEachNear(const FloatBox& query, Visit&& visit) const noexcept {
    walkTree(nodes_, TouchingBox{query}, visit);
  }

  /// The same for the boxes nearer to p_W than `reach` along every axis.
  template <typename Visit>
  void forEachNear(const Vector3& p_W, double reach, Visit&& visit) const noexcept {
    forEachNear(around(p_W, reach), visit);
  }

  /// The same for the boxes that are no farther from p_W than `reach`.
  template <typename Visit>
  void forEachWithin(const Vector3& p_W, double reach, Visit&& visit) const noexcept {
    walkTree(nodes_, WithinReach(p_W, reach, origin_), visit);
  }

  /// The same for the boxes that a ball of radius `reach` may touch on the straight way from one place to another: all
  /// that it touches, and a few that are near the way.
  template <typename Visit>
  void forEachAlong(const Vector3& from_W, const Vector3& to_W, double reach, Visit&& visit) const noexcept {
    walkTree(nodes_, AlongWay(from_W, to_W, reach, origin_), visit);
  }

  /// Lists the items whose boxes are no farther from a box than `reach`, level by level: most of what is read of the
  /// tree is then on its way from memory at once, and nothing is guessed about what is near. Returns their number, or
  /// nothing where there are more, or where the walk is a long one.
  /// @param isListed  is called with each item as soon as it is: while the walk goes on, it may fetch what it needs
  template <typename Listed>
  std::optional<std::size_t> listWithin(const Bounds& from, double reach, std::span<std::uint32_t> items,
                                        Listed&& isListed) const noexcept {
    return listItems(nodes_, WithinReach(from, reach, origin_), items, isListed);
  }

  /// The same of some of the nodes alone; nothing where there are more.
  std::optional<std::size_t> listOf(std::span<const std::uint32_t> nodes, const Bounds& from, double reach,
                                    std::span<std::uint32_t> items) const noexcept;

  /// One bit for each box of one of the nodes that is no farther from p_W than `reach`.
  unsigned within(const BoxNode& node, const Vector3& p_W, double reach) const noexcept {
    return WithinReach(p_W, reach, origin_)(node);
  }

  /// Calls measure(item), which returns a distance, for boxes in the order of their nearness to p_W, as long as a box
  /// is nearer than `reach` and than the smallest distance measured so far. Returns that distance, or `reach`.
  /// A distance is not negative.
  template <typename Measure>
  double nearest(const Vector3& p_W, double reach, Measure&& measure) const noexcept {
    return searchNearest(nodes_, outwards(p_W, p_W, origin_), reach, measure);
  }

 private:
  std::vector<BoxNode> nodes_;  ///< the root first; parents before children
  Vector3 origin_ = Vector3::Zero();
  double farOff_ = 0;  ///< how large the numbers of the origin are [m]
  std::size_t size_ = 0;
};

}  // namespace haptiv
