#include "haptics/contact/MeshNeighbourhood.h"

#include <array>
#include <optional>

#include "haptics/index/Fetch.h"
#include "haptics/meshes/BlockBounds.h"

namespace haptiv {
namespace {

/// The proxy goes with its goal; held back, along what holds it.
Vector3 likelyStep(const Vector3& proxy, const Vector3& step, const Vector3& goalBefore, double radius) noexcept {
  const Vector3 held = proxy - goalBefore;
  const double depth = held.norm();
  if (!(depth > 1e-3 * radius)) return step;
  const Vector3 out = held / depth;
  const double outwards = out.dot(step);
  return outwards < depth ? Vector3(step - outwards * out) : step;
}

}  // namespace

MeshNeighbourhood::MeshNeighbourhood(const HapticScene& scene, const Vector3& proxy, const Vector3& step,
                                     const Vector3& goal, double radius, RememberedBlocks& blocks) noexcept
    : scene_(scene), blocks_(blocks), radius_(radius) {
  if (scene.meshIndex.tree.size() == 0 && scene.wallIndex.tree.size() == scene.walls.size()) return;
  constexpr double kFelt = 1 + 1.0 / 128, kBeside = 0.1, kAnywhere = 0.6;  // of the radius; and of the step
  const double way = step.norm();
  const double certain = 1.001 * (radius + (goal - proxy).norm()) + 0.5 * way;
  const Vector3 half = 0.5 * likelyStep(proxy, step, goal - step, radius);
  wide_ = {proxy + 0.5 * step, Vector3::Zero(), std::min(kFelt * radius + kAnywhere * way, certain)};
  forEachMeshWallWithin(scene, wide_.middle, certain, [&](std::uint32_t) { isEmpty_ = false; });
  if (isEmpty_) return;
  likely_ = {proxy + half, half, std::min(kFelt * radius + kBeside * way, certain)};
  find(likely_);
}

void MeshNeighbourhood::lookAhead() noexcept {
  constexpr double kHaste = 0.25, kMargin = 0.75;  // of the radius
  constexpr int kMuch = 5;
  const Vector3 step = 2 * likely_.half;
  if (isEmpty_ || !(step.norm() < kHaste * radius_) || blocks_.mayRest(asked_ >= kMuch)) return;
  blocks_.lookAhead(scene_, likely_.middle, step, likely_.farthest(), kMargin * radius_);
}

void MeshNeighbourhood::find(const ProxyWay& around) noexcept {
  found_ = around;
  kept_.clear(around.middle);
  std::array<std::uint32_t, KeptTriangles::kMost> room;
  const auto keep = [&](std::uint32_t wall, std::span<const std::uint32_t> blocks) { return keepNear(wall, blocks); };
  const GatheredBlocks* known = blocks_.around(around.middle, around.farthest());
  isKept_ = known != nullptr ? known->forEachWall(scene_, around.box(), around.reach, room, keep) : searchTrees();
  kept_.fetchCorners(scene_);
}

bool MeshNeighbourhood::searchTrees() noexcept {
  std::array<std::uint32_t, KeptTriangles::kMost> room;
  bool fits = true;
  forEachMeshWallWithin(scene_, found_.middle, found_.farthest(), [&](std::uint32_t wall) {
    const TriangleMesh& mesh = *scene_.walls[wall].shape.mesh;
    const auto soon = [&](std::uint32_t block) { fetch(mesh.blocks[block]); };
    const auto count = fits ? mesh.tree.listWithin(found_.box(), found_.reach, room, soon) : std::nullopt;
    fits = count && keepNear(wall, std::span(room).first(*count));
  });
  return fits;
}

/// In two rounds, so that the processor need not guess which triangles are near.
bool MeshNeighbourhood::keepNear(std::uint32_t wall, std::span<const std::uint32_t> blocks) noexcept {
  constexpr std::uint32_t kSize = TriangleBlock::kSize;
  constexpr std::size_t kMost = KeptTriangles::kMost;
  const TriangleMesh& mesh = *scene_.walls[wall].shape.mesh;
  const auto half = found_.half.cast<float>();
  const auto reach = static_cast<float>((1 + 1e-6) * found_.reach);
  std::array<BlockBounds, kMost> bounds;
  std::array<std::uint32_t, kMost + kSize> near;  // which lane of which of them
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < blocks.size(); ++i) {
    boundBlock(mesh.blocks[blocks[i]], found_.middle, bounds[i]);
    const unsigned bits = bounds[i].nearWay({half.x(), half.y(), half.z()}, reach) & mesh.lanesOf(blocks[i]);
    for (std::uint32_t lane = 0; lane < kSize; ++lane) {
      near[count] = i * kSize + lane;
      count += bits >> lane & 1U;
    }
    if (!kept_.hasRoomFor(count)) return false;
  }
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t i = near[k] / kSize, triangle = blocks[i] * kSize + near[k] % kSize;
    const int lane = static_cast<int>(near[k] % kSize);
    fetch(mesh.triangles[triangle]);
    kept_.add({wall, triangle}, bounds[i].normalOf(lane), bounds[i].distance[lane]);
  }
  return true;
}

}  // namespace haptiv
