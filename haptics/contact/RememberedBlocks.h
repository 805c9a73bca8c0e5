#pragma once

#include "haptics/contact/GatheredBlocks.h"

namespace haptiv {

/// Where the triangles around the proxy stand in the trees of their meshes, remembered from tick to tick, so that a
/// tick neither walks down the trees nor waits for memory. What lies ahead is gathered, a little in each tick. It
/// changes nothing but the time. It knows one version of a scene: whoever turns to another one has to forget() first.
/// Realtime-safe: yes.
class RememberedBlocks {
 public:
  void forget() noexcept { *this = {}; }

  /// Where all blocks within `reach` of p_W are known, those; else null.
  const GatheredBlocks* around(const Vector3& p_W, double reach) const noexcept {
    return known().fits() && known().holds(p_W, reach) ? &known() : nullptr;
  }

  /// Whether it need not look ahead in this tick, if it had rather not: not twice in a row.
  bool mayRest(bool wantsTo) noexcept { return rests_ = wantsTo && !rests_; }

  /// Gathers a little of what will be asked for, where p_W goes on by `step` in a tick, and what is within `reach` is
  /// asked for in each [m].
  /// @param margin  how much farther to look [m]
  void lookAhead(const HapticScene& scene, const Vector3& p_W, const Vector3& step, double reach,
                 double margin) noexcept;

 private:
  const GatheredBlocks& known() const noexcept { return gathered_[now_]; }

  std::array<GatheredBlocks, 2> gathered_;
  std::size_t now_ = 0;   ///< which of them is known; the other one is gathered, and then waits to take its place
  bool gathers_ = false;  ///< or waits
  bool rests_ = false;    ///< did not look ahead in this tick
};

}  // namespace haptiv
