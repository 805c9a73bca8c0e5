#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "haptics/planes/NearestCorner.h"

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
  ///
  /// One and two planes in closed form; more by Newton's method on the planes that push: a few steps, each a system of
  /// as many planes as push, 3 x 3 at most. Realtime-safe: yes.
  void shareOut(const Vector3& p) noexcept { shareOut(p, p); }

  /// The same, and the nearest point to p that is in all of them: exact, as the sum of the shares is not. Where no
  /// point is in all of them (a gap narrower than the ball) it is where the shares lead to: between.
  ///
  /// @param guess  where it probably is: saves steps, and does not change the point
  /// Realtime-safe: yes.
  Vector3 nearest(const Vector3& p, const Vector3& guess) noexcept;
  Vector3 nearest(const Vector3& p) noexcept { return nearest(p, p); }

 private:
  static constexpr double kGive = 1.0 / 128;  ///< d
  static constexpr int kSteps = 20, kHalvings = 10;
  using Set = std::uint32_t;  ///< of planes, a bit each

  /// Those that push, and where their shares lead to, from p.
  struct Shared {
    Set planes = 0;
    Vector3 way = Vector3::Zero();
  };
  Shared shareOut(const Vector3& p, const Vector3& guess) noexcept;
  /// The planes that push at y, by depth_.
  Set pushAt(const Vector3& y) noexcept;
  /// 2 d times the function to be minimised.
  double energyAt(const Vector3& y) const noexcept;
  /// Where exactly these planes push.
  Vector3 balance(Set planes) const noexcept;
  /// The shares of two planes that both push; where one is negative, they do not.
  std::array<double, 2> sharesOfTwo(std::size_t i, std::size_t j) const noexcept;
  Shared settle(const Vector3& guess) noexcept;
  /// The same, where these planes probably push.
  Shared settleFrom(Set planes) noexcept;
  /// The same of just two planes, wherever they push.
  Shared settleTwo() noexcept;
  /// The nearest point on all of these planes, from p.
  std::optional<Vector3> meetingOf(Set planes) const noexcept;
  bool allHold(const Vector3& y) const noexcept;

  static std::size_t firstOf(Set planes) noexcept { return static_cast<std::size_t>(std::countr_zero(planes)); }
  static Set butFirst(Set planes) noexcept { return planes & (planes - 1); }
  std::size_t size() const noexcept { return static_cast<std::size_t>(count); }

  std::array<double, Capacity> missing_;  ///< r
  std::array<double, Capacity> depth_;    ///< r - n . y where positive, else 0
  double largest_;                        ///< of the |r|
};

template <int Capacity>
typename HalfSpaces<Capacity>::Set HalfSpaces<Capacity>::pushAt(const Vector3& y) noexcept {
  Set pushing = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    const double depth = missing_[i] - normal[i].dot(y);
    depth_[i] = std::max(depth, 0.0);
    pushing |= static_cast<Set>(depth > 0) << i;
  }
  return pushing;
}

template <int Capacity>
double HalfSpaces<Capacity>::energyAt(const Vector3& y) const noexcept {
  double energy = kGive * y.squaredNorm();
  for (std::size_t i = 0; i < size(); ++i) {
    const double depth = std::max(missing_[i] - normal[i].dot(y), 0.0);
    energy += depth * depth;
  }
  return energy;
}

template <int Capacity>
std::array<double, 2> HalfSpaces<Capacity>::sharesOfTwo(std::size_t i, std::size_t j) const noexcept {
  const double cosine = normal[i].dot(normal[j]);
  const double inverse = 1 / ((1 + kGive) * (1 + kGive) - cosine * cosine);
  return {((1 + kGive) * missing_[i] - cosine * missing_[j]) * inverse,
          ((1 + kGive) * missing_[j] - cosine * missing_[i]) * inverse};
}

template <int Capacity>
Vector3 HalfSpaces<Capacity>::balance(Set planes) const noexcept {
  if (planes == 0) return Vector3::Zero();
  const Set others = butFirst(planes);
  if (others == 0) return missing_[firstOf(planes)] / (1 + kGive) * normal[firstOf(planes)];
  if (butFirst(others) == 0) {
    const std::size_t i = firstOf(planes), j = firstOf(others);
    const auto [first, second] = sharesOfTwo(i, j);
    return first * normal[i] + second * normal[j];
  }
  Matrix3 sum = kGive * Matrix3::Identity();
  Vector3 pull = Vector3::Zero();
  for (Set left = planes; left != 0; left = butFirst(left)) {
    const std::size_t i = firstOf(left);
    sum += normal[i] * normal[i].transpose();
    pull += missing_[i] * normal[i];
  }
  return sum.inverse() * pull;
}

template <int Capacity>
typename HalfSpaces<Capacity>::Shared HalfSpaces<Capacity>::settle(const Vector3& guess) noexcept {
  Shared now{pushAt(guess), guess};
  for (int step = 0; step < kSteps; ++step) {
    Vector3 next = balance(now.planes);
    Set then = pushAt(next);
    if (then == now.planes) return {then, next};
    const double energy = energyAt(now.way);
    for (int half = 0; half < kHalvings && then != now.planes && energyAt(next) > energy; ++half) {
      next = 0.5 * (now.way + next);
      then = pushAt(next);
    }
    now = {then, next};
  }
  return now;
}

template <int Capacity>
typename HalfSpaces<Capacity>::Shared HalfSpaces<Capacity>::settleFrom(Set planes) noexcept {
  const Vector3 y = balance(planes);
  return pushAt(y) == planes ? Shared{planes, y} : settle(y);
}

template <int Capacity>
typename HalfSpaces<Capacity>::Shared HalfSpaces<Capacity>::settleTwo() noexcept {
  auto [first, second] = sharesOfTwo(0, 1);
  const bool bothPush = first > 0 && second > 0;
  if (!bothPush) {  // one would have to pull: the other pushes alone
    const bool isFirst = second > 0 ? false : missing_[0] > 0;
    first = isFirst ? missing_[0] / (1 + kGive) : 0;
    second = isFirst ? 0 : std::max(missing_[1], 0.0) / (1 + kGive);
  }
  depth_[0] = kGive * first;
  depth_[1] = kGive * second;
  return {(first > 0 ? 1U : 0U) | (second > 0 ? 2U : 0U), first * normal[0] + second * normal[1]};
}

template <int Capacity>
typename HalfSpaces<Capacity>::Shared HalfSpaces<Capacity>::shareOut(const Vector3& p, const Vector3& guess) noexcept {
  bool isPushed = false;
  largest_ = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    missing_[i] = offset[i] - normal[i].dot(p);
    share[i] = 0;
    isPushed = isPushed || missing_[i] > 0;
    largest_ = std::max(largest_, std::abs(missing_[i]));
  }
  if (!isPushed) return {};
  if (count == 1) {
    share[0] = missing_[0];
    return {1, missing_[0] * normal[0]};
  }
  const Shared rough = count == 2 ? settleTwo() : settle((1 - 2 * kGive) * (guess - p));
  std::array<double, Capacity> asked;
  for (std::size_t i = 0; i < size(); ++i) {
    asked[i] = missing_[i];
    missing_[i] += depth_[i];
  }
  Shared shared = count == 2 ? settleTwo() : settleFrom(rough.planes);
  for (std::size_t i = 0; i < size(); ++i) missing_[i] = asked[i];
  double squares = 0;
  for (Set left = shared.planes; left != 0; left = butFirst(left)) {
    const std::size_t i = firstOf(left);
    share[i] = depth_[i] / kGive;
    squares += share[i] * share[i];
  }
  const double way = shared.way.squaredNorm();
  const double give = kGive * std::min(1.0, squares / way);
  const double stretch = 1 / (1 - give * give / ((1 + give) * (1 + give)));
  for (Set left = shared.planes; left != 0; left = butFirst(left)) share[firstOf(left)] *= stretch;
  shared.way *= stretch;
  return shared;
}

template <int Capacity>
bool HalfSpaces<Capacity>::allHold(const Vector3& y) const noexcept {
  double left = 0;
  for (std::size_t i = 0; i < size(); ++i) left = std::max(left, missing_[i] - normal[i].dot(y));
  return left <= 1e-12 * largest_;
}

template <int Capacity>
std::optional<Vector3> HalfSpaces<Capacity>::meetingOf(Set planes) const noexcept {
  std::array<std::size_t, 3> of{};
  const int members = std::popcount(planes);
  if (members == 0 || members > 3) return std::nullopt;
  for (std::size_t k = 0; planes != 0; planes = butFirst(planes)) of[k++] = firstOf(planes);
  const auto [i, j, k] = of;
  if (members == 1) return missing_[i] * normal[i];
  if (members == 2) return nearestOnEdge(normal[i], missing_[i], normal[j], missing_[j]);
  return nearestInCorner(normal[i], missing_[i], normal[j], missing_[j], normal[k], missing_[k]);
}

template <int Capacity>
Vector3 HalfSpaces<Capacity>::nearest(const Vector3& p, const Vector3& guess) noexcept {
  const Shared shared = shareOut(p, guess);
  if (shared.planes == 0 || count == 1) return p + shared.way;
  const std::optional<Vector3> meeting = meetingOf(shared.planes);
  if (meeting && allHold(*meeting)) return p + *meeting;
  return p + nearestCorner({normal.data(), size()}, {missing_.data(), size()}).value_or(shared.way);
}

}  // namespace haptiv
