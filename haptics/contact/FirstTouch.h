#pragma once

#include <algorithm>
#include <cmath>

#include "device/types.h"

namespace haptiv {

/// The straight way of a ball. Triangles that it only grazes do not stop it: those that it meets so flatly that it is a
/// thousandth of the way deep in them at the end, an eighth of the radius at most; and those that it passes no deeper
/// than a bump.
struct BallWay {
  static constexpr double kGraze = 1e-3, kDeepestGraze = 1.0 / 8;  ///< of the way; of the radius
  static constexpr double kBump = 1.0 / 4096;                      ///< of the radius; as well no more than a graze

  Vector3 from, direction;  ///< in W [m]; unit
  double length, radius;    ///< [m]
  double tolerance;         ///< a gap no larger is a touch [m]

  double flattest(double along) const noexcept { return std::min(kGraze, kDeepestGraze * radius / (length - along)); }
  double bump() const noexcept { return std::min(kGraze * length, kBump * radius); }
};

/// Between the ball and a triangle, at some place of the ball's way. Along the way it is convex.
struct Gap {
  double along;   ///< where: how far the ball has gone [m]
  double size;    ///< negative: that deep is the ball in [m]
  double growth;  ///< of the size along the way
  double passes;  ///< how much farther on the ball is nearest to what is now the triangle's nearest point [m]

  /// How small it will get to that point.
  double leastToPoint(double radius) const noexcept {
    const double distance = size + radius;
    return std::sqrt(std::max(0.0, distance * distance - passes * passes)) - radius;
  }
  /// Where it would close if it went on as it does here: before the touch, as it is convex.
  double closes() const noexcept { return along - size / growth; }
};

/// The smallest gap that there may be until `end`: it is nowhere below the lines along it at two places.
/// @param before  where it still shrinks
inline double leastGap(const Gap& before, const Gap& now, double end) noexcept {
  if (!(now.growth > 0)) return now.size + now.growth * (end - now.along);
  const double back = now.size - now.growth * (now.along - before.along);
  return before.size + before.growth * (back - before.size) / (before.growth - now.growth);
}

/// How far a ball gets on its way, up to `free`, before it touches a triangle, which it does not before `start` [m].
///
/// Newton's steps come to the first touch from before it. Where the ball goes by closely, or grazes, they are many and
/// small: if it may, a look at the place where it passes tells so, or leads back to the touch.
/// @param awayOf  (p_W) leads from the triangle's nearest point to a place
/// Realtime-safe: yes.
template <typename AwayOf>
double wayToTouch(const BallWay& way, double start, double free, AwayOf&& awayOf) noexcept {
  constexpr int kSteps = 40, kLooks = 2;
  constexpr double kBeyond = 1.25;  // of the way to there: edges are passed later than points
  const auto gapAt = [&](double along) {
    const Vector3 away = awayOf(way.from + along * way.direction);
    const double distance = away.norm(), growth = away.dot(way.direction);
    return Gap{along, distance - way.radius, distance > 0 ? growth / distance : 0, -growth};
  };
  const double deepest = -way.bump();
  double gone = start;
  for (int step = 0, looks = 0; step < kSteps; ++step) {
    const Gap gap = gapAt(gone);
    if (!(gap.growth < -way.flattest(gone))) return free;
    if (gap.size <= way.tolerance) break;
    double next = gap.closes();
    if (!(next < free)) return free;
    if (looks < kLooks && gap.leastToPoint(way.radius) >= deepest) {
      const Gap beyond = gapAt(std::clamp(gone + kBeyond * gap.passes, next, free));
      if (leastGap(gap, beyond, free) >= deepest) return free;
      if (beyond.growth < 0) next = std::max(next, beyond.closes());
      looks = beyond.size < deepest ? kLooks : looks + 1;
      if (!(next < free)) return free;
    }
    gone = next;
  }
  return gone;
}

}  // namespace haptiv
