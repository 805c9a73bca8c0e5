#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "haptics/planes/NearestCorner.h"
#include "haptics/planes/PlaneShares.h"

namespace haptiv {

/// Half spaces normal . x >= offset, in W, in which a point may be.
template <int Capacity>
struct HalfSpaces {
  static_assert(Capacity <= 32);
  std::array<Vector3, Capacity> normal;  ///< unit
  std::array<double, Capacity> offset;   ///< [m]
  std::array<double, Capacity> share;    ///< out: of the way back to them, along the normal, >= 0 [m]
  int count = 0;

  void add(const Vector3& unitNormal, double newOffset) noexcept {
    normal[static_cast<std::size_t>(count)] = unitNormal;
    offset[static_cast<std::size_t>(count++)] = newOffset;
  }

  /// How much each pushes p out.
  ///
  /// Where the planes are (almost) parallel, infinitely many shares lead to one point, and a plane that comes into play
  /// would step in with all of its share. So each plane gives way a little: the shares s >= 0 are those of
  ///
  ///   min |y|^2 / 2 + sum max(0, r_i - n_i . y)^2 / 2d,   r_i = offset_i - n_i . p,   s_i = max(0, r_i - n_i . y) / d
  ///
  /// This is solved twice, the second time with r_i larger by what plane i gave way (a step of the proximal method),
  /// and the shares are stretched to reach the planes. They are unique, change continuously with all planes (by no more
  /// than 2 / d times as much) and do not depend on their order: planes on one spot share alike. Their sum along the
  /// normals is the way to the nearest point for one plane and for coinciding ones, else within some d^2 of it: so a
  /// plane that is met when the others hold p already, as that of a triangle is, comes in with next to no share.
  /// Realtime-safe: yes.
  void shareOut(const Vector3& p) noexcept { shareOut(p, p); }

  /// The same, and the nearest point to p that is in all of them: exact, as the sum of the shares is not. Where no
  /// point is in all of them (a gap narrower than the ball) it is where the shares lead to: between.
  ///
  /// @param guess  where it probably is: saves steps, and does not change the point
  /// Realtime-safe: yes.
  [[gnu::flatten]] Vector3 nearest(const Vector3& p, const Vector3& guess) noexcept;
  Vector3 nearest(const Vector3& p) noexcept { return nearest(p, p); }

 private:
  using Settled = PlaneShares::Settled;

  /// Where the shares lead to, from p, and which planes push.
  [[gnu::always_inline]] inline Settled shareOut(const Vector3& p, const Vector3& guess) noexcept;
  /// How far the planes leave out p, and which of them p + y, too.
  [[gnu::always_inline]] inline PlaneSet measureFrom(const Vector3& p, const Vector3& y) noexcept;
  /// The nearest point on all of these planes, from p.
  [[gnu::noinline]] std::optional<Vector3> meetingOf(PlaneSet planes) const noexcept;
  /// Of three, two that are almost parallel share, and yet only one of them is reached.
  std::optional<Vector3> meetingWithoutLeast(std::size_t i, std::size_t j, std::size_t k) const noexcept {
    if (share[j] < share[i]) std::swap(i, j);
    if (share[k] < share[i]) std::swap(i, k);
    return nearestOnEdge(normal[j], missing_[j], normal[k], missing_[k]);
  }
  [[gnu::always_inline]] inline bool allHold(const Vector3& y) const noexcept;
  std::size_t size() const noexcept { return static_cast<std::size_t>(count); }

  std::array<double, Capacity> missing_;  ///< r
  double most_, largest_;                 ///< of the r; of the |r|
};

template <int Capacity>
PlaneSet HalfSpaces<Capacity>::measureFrom(const Vector3& p, const Vector3& y) noexcept {
  const Pair x = {p.x(), y.x()}, v = {p.y(), y.y()}, w = {p.z(), y.z()};
  PlaneSet leaving = 0;
  double least = 0;
  most_ = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    const Vector3& n = normal[i];
    const Pair along = n.x() * x + n.y() * v + n.z() * w;
    share[i] = 0;
    missing_[i] = offset[i] - along[0];
    leaving |= static_cast<PlaneSet>(missing_[i] > along[1]) << i;
    most_ = std::max(most_, missing_[i]);
    least = std::min(least, missing_[i]);
  }
  largest_ = std::max(most_, -least);
  return leaving;
}

template <int Capacity>
typename HalfSpaces<Capacity>::Settled HalfSpaces<Capacity>::shareOut(const Vector3& p, const Vector3& guess) noexcept {
  const Vector3 start = PlaneShares::startAt(guess - p);
  const PlaneSet likely = measureFrom(p, start);
  if (!(most_ > 0)) return {0, true, true};
  if (count == 1) {
    share[0] = missing_[0];
    return {1, true, true, missing_[0] * normal[0]};
  }
  PlaneShares shares({normal.data(), size()}, {missing_.data(), size()}, {share.data(), size()}, largest_);
  return shares.shareOut(likely, start);
}

template <int Capacity>
bool HalfSpaces<Capacity>::allHold(const Vector3& y) const noexcept {
  double left = 0;
  for (std::size_t i = 0; i < size(); ++i) left = std::max(left, missing_[i] - normal[i].dot(y));
  return left <= 1e-12 * largest_;
}

template <int Capacity>
std::optional<Vector3> HalfSpaces<Capacity>::meetingOf(PlaneSet planes) const noexcept {
  switch (sizeUpToThree(planes)) {
    case 1: {
      const auto [i] = membersOf<1>(planes);
      return missing_[i] * normal[i];
    }
    case 2: {
      const auto [i, j] = membersOf<2>(planes);
      return nearestOnEdge(normal[i], missing_[i], normal[j], missing_[j]);
    }
    case 3: {
      const auto [i, j, k] = membersOf<3>(planes);
      const auto corner = nearestInCorner(normal[i], missing_[i], normal[j], missing_[j], normal[k], missing_[k]);
      return corner ? corner : meetingWithoutLeast(i, j, k);
    }
    default:
      return std::nullopt;
  }
}

template <int Capacity>
Vector3 HalfSpaces<Capacity>::nearest(const Vector3& p, const Vector3& guess) noexcept {
  const Settled shared = shareOut(p, guess);
  if (shared.isNearest) return p + shared.way;
  const std::optional<Vector3> meeting = meetingOf(shared.pushing);
  if (meeting && allHold(*meeting)) return p + *meeting;
  return p + nearestCorner({normal.data(), size()}, {missing_.data(), size()}).value_or(shared.way);
}

}  // namespace haptiv
