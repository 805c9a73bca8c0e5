#include "haptics/scene/SceneIndexer.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "haptics/shapes/ShapeDistance.h"
#include "haptics/shapes/StraightBoxSurface.h"

namespace haptiv {
namespace {

constexpr std::uint32_t kGone = TreeBefore::kGone;

ShapeIndex::Entry entryOf(const Shape& shape, std::uint32_t number) {
  ShapeIndex::Entry entry;
  entry.shape = number;
  const auto box = shape.kind == Shape::Kind::box ? straightBox(shape) : std::nullopt;
  entry.isStraight = box.has_value();
  if (!box) return entry;
  entry.box = *box;
  entry.isUpright = isUpright(*box);
  return entry;
}

template <typename Felt>
std::vector<std::uint32_t> orderById(const std::vector<Felt>& shapes) {
  std::vector<std::uint32_t> order(shapes.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto byId = [&](std::uint32_t a, std::uint32_t b) {
    return shapes[a].id != shapes[b].id ? shapes[a].id < shapes[b].id : a < b;
  };
  if (!std::is_sorted(order.begin(), order.end(), byId)) std::sort(order.begin(), order.end(), byId);
  return order;
}

MeshIndex meshesOf(const std::vector<Wall>& walls) {
  MeshIndex index;
  std::vector<Bounds> bounds;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Shape& shape = walls[i].shape;
    if (shape.kind != Shape::Kind::mesh || !shape.mesh) continue;
    bounds.push_back(boundsOf(shape));
    index.wall.push_back(static_cast<std::uint32_t>(i));
  }
  index.tree = BoundingTree(bounds);
  return index;
}

}  // namespace

/// One of the two indices, from its version before.
class SceneIndexer::Update {
 public:
  template <typename Felt>
  static ShapeIndex fresh(const std::vector<Felt>& shapes, Plan& plan) {
    std::vector<Bounds> bounds;
    bounds.reserve(shapes.size());
    for (const Felt& each : shapes) bounds.push_back(boundsOf(each.shape));
    plan.bounds = BoundsOfAll(bounds);
    ShapeIndex index;
    index.tree = BoundingTree(bounds, plan.bounds.bounds(), &plan.tree);
    index.entries.reserve(shapes.size());
    for (const std::uint32_t shape : index.tree.renumber()) {
      index.entries.push_back(entryOf(shapes[shape].shape, shape));
    }
    index.byId = orderById(shapes);
    return index;
  }

  template <typename Felt>
  static ShapeIndex from(const ShapeIndex& old, const std::vector<Felt>& before, const std::vector<Felt>& now,
                         const KeptRuns& runs, Plan& plan) {
    if (old.tree.size() != before.size() || plan.tree.nodes.size() != old.tree.nodes().size()) return fresh(now, plan);
    const KeptShapes kept = keptOf(now, before, runs);
    if (kept.isAll) return old;
    if (!keepsOrigin(old.tree.origin(), before, now, kept, plan.bounds)) return fresh(now, plan);
    std::vector<std::uint32_t> itemNow(old.entries.size());
    for (std::size_t i = 0; i < itemNow.size(); ++i) itemNow[i] = kept.nowOf[old.entries[i].shape];
    TreePlan next;
    ShapeIndex index;
    index.tree =
        BoundingTree(rebuildNodes(itemsOf(old.tree, now, kept, itemNow), {old.tree.nodes(), plan.tree, itemNow}, next),
                     old.tree.origin(), now.size());
    plan.tree = std::move(next);
    index.entries = entriesOf(index.tree.renumber(), old, now, itemNow);
    index.byId = orderById(now);
    return index;
  }

 private:
  /// Whether the tree would still be seen from the same place.
  template <typename Felt>
  static bool keepsOrigin(const Vector3& origin, const std::vector<Felt>& before, const std::vector<Felt>& now,
                          const KeptShapes& kept, BoundsOfAll& bounds) {
    bool isKnown = true;
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (kept.isNew[i]) bounds.add(boundsOf(now[i].shape));
    }
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (kept.nowOf[i] == kGone) isKnown = bounds.remove(boundsOf(before[i].shape)) && isKnown;
    }
    if (!isKnown) {
      bounds = {};
      for (const Felt& each : now) bounds.add(boundsOf(each.shape));
    }
    return originOf(bounds.bounds()) == origin;
  }

  /// Those that were kept stand in the order of the tree before, whose boxes are theirs.
  template <typename Felt>
  static std::vector<SplitItem> itemsOf(const BoundingTree& old, const std::vector<Felt>& now, const KeptShapes& kept,
                                        const std::vector<std::uint32_t>& itemNow) {
    std::vector<SplitItem> items;
    items.reserve(now.size());
    for (const BoxNode& node : old.nodes()) {
      for (std::size_t place = 0; place < BoxNode::kWidth; ++place) {
        const std::uint32_t child = node.child[place];
        if (child == BoxNode::kNone || (child & BoxNode::kItemFlag) == 0) continue;
        const std::uint32_t shape = itemNow[child & ~BoxNode::kItemFlag];
        if (shape != kGone) items.emplace_back(node.box(place), shape, false);
      }
    }
    for (std::uint32_t i = 0; i < now.size(); ++i) {
      if (!kept.isNew[i]) continue;
      const Bounds bounds = boundsOf(now[i].shape);
      items.emplace_back(outwards(bounds.low, bounds.high, old.origin()), i, true);
    }
    return items;
  }

  template <typename Felt>
  static std::vector<ShapeIndex::Entry> entriesOf(const std::vector<std::uint32_t>& shapeOfItem, const ShapeIndex& old,
                                                  const std::vector<Felt>& now,
                                                  const std::vector<std::uint32_t>& itemNow) {
    std::vector<std::uint32_t> itemBefore(now.size(), kGone);
    for (std::uint32_t i = 0; i < itemNow.size(); ++i) {
      if (itemNow[i] != kGone) itemBefore[itemNow[i]] = i;
    }
    std::vector<ShapeIndex::Entry> entries;
    entries.reserve(shapeOfItem.size());
    for (const std::uint32_t shape : shapeOfItem) {
      const std::uint32_t item = itemBefore[shape];
      entries.push_back(item == kGone ? entryOf(now[shape].shape, shape) : old.entries[item]);
      entries.back().shape = shape;
    }
    return entries;
  }
};

void SceneIndexer::index(HapticScene& scene) {
  scene.wallIndex = Update::fresh(scene.walls, walls_);
  scene.zoneIndex = Update::fresh(scene.zones, zones_);
  scene.meshIndex = meshesOf(scene.walls);
}

void SceneIndexer::index(HapticScene& scene, const HapticScene& before, const KeptRuns& walls, const KeptRuns& zones) {
  scene.wallIndex = Update::from(before.wallIndex, before.walls, scene.walls, walls, walls_);
  scene.zoneIndex = Update::from(before.zoneIndex, before.zones, scene.zones, zones, zones_);
  scene.meshIndex = meshesOf(scene.walls);
}

void computeBounds(HapticScene& scene) {
  SceneIndexer().index(scene);
}

}  // namespace haptiv
