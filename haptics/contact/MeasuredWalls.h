#pragma once

#include "haptics/contact/NearSurfaces.h"
#include "haptics/shapes/TwoBoxes.h"

namespace haptiv {

/// Measures exact walls from a place, and lists those that are nearer than `reach`. Lives for a search.
/// Realtime-safe: yes.
class MeasuredWalls {
 public:
  MeasuredWalls(const HapticScene& scene, const Vector3& place, double reach, NearSurfaces& near) noexcept
      : scene_(scene), place_(place), reach_(reach), near_(near) {
    near_.count = 0;
  }

  /// All that are near, however many boxes that takes: the nearest ones where they are too many, by rising number.
  /// Apart from who calls it, whose own way is short and is gone in nearly all ticks.
  [[gnu::noinline]] void search() noexcept;

  /// By rising number, and no more than there is room for. The same one twice is one.
  [[gnu::always_inline]] void measureTwo(const ShapeIndex::Entry& a, const ShapeIndex::Entry& b) noexcept {
    if (a.isUpright & b.isUpright) return measureTwo<true>(a, b);
    if (a.isStraight & b.isStraight) return measureTwo<false>(a, b);
    measureEach(a, b);
  }

 private:
  void measure(const ShapeIndex::Entry& entry) noexcept;
  template <bool Upright>
  [[gnu::always_inline]] void measureTwo(const ShapeIndex::Entry& a, const ShapeIndex::Entry& b) noexcept {
    const TwoSurfaces two = haptiv::measureTwo<Upright>(place_, a.box, b.box);
    if (!(two.isOutside[0] & two.isOutside[1])) return measureEach(a, b);
    const PairMask isNear = two.distance < twice(reach_);
    list<0>(two, a, isNear);
    if (&a != &b) list<1>(two, b, isNear);
  }
  void measureEach(const ShapeIndex::Entry& a, const ShapeIndex::Entry& b) noexcept;
  /// Written in any case and then counted or not: nobody could foresee a jump.
  template <int Lane>
  [[gnu::always_inline]] void list(const TwoSurfaces& two, const ShapeIndex::Entry& entry,
                                   const PairMask& isNear) noexcept {
    NearSurface& next = near_.surface[near_.count];
    next.wall = static_cast<std::int32_t>(entry.shape);
    next.face = static_cast<int>(two.face[Lane]);
    next.distance = two.distance[Lane];
    next.normal = {two.normal[0][Lane], two.normal[1][Lane], two.normal[2][Lane]};
    near_.count -= static_cast<std::size_t>(isNear[Lane]);
  }

  const HapticScene& scene_;
  const Vector3& place_;
  double reach_;
  NearSurfaces& near_;
};

}  // namespace haptiv
