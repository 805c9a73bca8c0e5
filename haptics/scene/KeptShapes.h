#pragma once

#include <cstdint>
#include <vector>

#include "haptics/index/TreePlan.h"
#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// Shapes that a scene has from the version before: `count` of them that stood there from number `before` on, now stand
/// from number `now` on. Id and place are the same; how they feel may be another.
struct KeptRun {
  std::uint32_t before = 0;
  std::uint32_t now = 0;
  std::uint32_t count = 0;

  bool operator==(const KeptRun&) const = default;
};
/// Rising in both numbers.
using KeptRuns = std::vector<KeptRun>;

/// Whether a shape is where it was.
template <typename Felt>
bool isWhereItWas(const Felt& a, const Felt& b) {
  return a.id == b.id && a.shape.kind == b.shape.kind && a.shape.centre == b.shape.centre &&
         a.shape.axes == b.shape.axes && a.shape.mesh == b.shape.mesh;
}

/// What became of the shapes of the version before.
struct KeptShapes {
  std::vector<std::uint32_t> nowOf;  ///< the number that each has now, or TreeBefore::kGone
  std::vector<bool> isNew;           ///< of those there are now
  bool isAll = true;                 ///< nothing was added, taken away or moved
};

template <typename Felt>
KeptShapes keptOf(const std::vector<Felt>& now, const std::vector<Felt>& before, const KeptRuns& runs) {
  KeptShapes kept{std::vector<std::uint32_t>(before.size(), TreeBefore::kGone), std::vector<bool>(now.size(), true)};
  std::uint32_t atBefore = 0, atNow = 0;
  const auto keep = [&] {
    kept.nowOf[atBefore++] = atNow;
    kept.isNew[atNow++] = false;
  };
  const auto pass = [&](std::uint32_t endBefore, std::uint32_t endNow) {
    const bool mayBeSame = endBefore - atBefore == endNow - atNow;
    while (mayBeSame && atNow < endNow) {
      if (isWhereItWas(now[atNow], before[atBefore])) {
        keep();
      } else {
        kept.isAll = false;
        ++atBefore, ++atNow;
      }
    }
    kept.isAll = kept.isAll && mayBeSame;
    atBefore = endBefore, atNow = endNow;
  };
  for (const KeptRun& run : runs) {
    pass(run.before, run.now);
    for (std::uint32_t i = 0; i < run.count; ++i) keep();
  }
  pass(static_cast<std::uint32_t>(before.size()), static_cast<std::uint32_t>(now.size()));
  return kept;
}

}  // namespace haptiv
