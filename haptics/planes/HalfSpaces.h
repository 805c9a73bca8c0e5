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
  /// Newton's method on the planes that push: a few steps, each a 3 x 3 system. Realtime-safe: yes.
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

  /// The planes that push at y, by depth_; in `energy` 2 d times the function to be minimised.
  struct Pushing {
    Set planes = 0;
    double energy = 0;
  };
  /// Those that push, and where their shares lead to, from p.
  struct Shared {
    Set planes = 0;
    Vector3 way = Vector3::Zero();
  };
  Shared shareOut(const Vector3& p, const Vector3& guess) noexcept;
  Pushing pushAt(const Vector3& y) noexcept;
  /// Where exactly these planes push.
  Vector3 balance(Set planes) const noexcept;
  Vector3 balanceOfTwo(std::size_t i, std::size_t j) const noexcept;
  Shared settle(const Vector3& guess) noexcept;
  /// The same, where these planes probably push.
  Shared settleFrom(Set planes) noexcept;
  bool allHold(const Vector3& y) const noexcept;

  static std::size_t firstOf(Set planes) noexcept { return static_cast<std::size_t>(std::countr_zero(planes)); }
  static Set butFirst(Set planes) noexcept { return planes & (planes - 1); }
  std::size_t size() const noexcept { return static_cast<std::size_t>(count); }

  std::array<double, Capacity> missing_;  ///< r
  std::array<double, Capacity> depth_;    ///< r - n . y where positive, else 0
  double largest_;                        ///< of the |r|
};

template <int Capacity>
typename HalfSpaces<Capacity>::Pushing HalfSpaces<Capacity>::pushAt(const Vector3& y) noexcept {
  Pushing pushing;
  pushing.energy = kGive * y.squaredNorm();
  for (std::size_t i = 0; i < size(); ++i) {
    const double depth = missing_[i] - normal[i].dot(y);
    depth_[i] = depth > 0 ? depth : 0;
    pushing.planes |= static_cast<Set>(depth > 0) << i;
    pushing.energy += depth_[i] * depth_[i];
  }
  return pushing;
}

template <int Capacity>
Vector3 HalfSpaces<Capacity>::balanceOfTwo(std::size_t i, std::size_t j) const noexcept {
  const double cosine = normal[i].dot(normal[j]);
  const double inverse = 1 / ((1 + kGive) * (1 + kGive) - cosine * cosine);
  const double first = ((1 + kGive) * missing_[i] - cosine * missing_[j]) * inverse;
  const double second = ((1 + kGive) * missing_[j] - cosine * missing_[i]) * inverse;
  return first * normal[i] + second * normal[j];
}

template <int Capacity>
Vector3 HalfSpaces<Capacity>::balance(Set planes) const noexcept {
  if (planes == 0) return Vector3::Zero();
  const Set others = butFirst(planes);
  if (others == 0) return missing_[firstOf(planes)] / (1 + kGive) * normal[firstOf(planes)];
  if (butFirst(others) == 0) return balanceOfTwo(firstOf(planes), firstOf(others));
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
  Vector3 y = guess;
  Pushing now = pushAt(y);
  for (int step = 0; step < kSteps; ++step) {
    Vector3 next = balance(now.planes);
    Pushing then = pushAt(next);
    const bool isSettled = then.planes == now.planes;
    for (int half = 0; half < kHalvings && then.planes != now.planes && then.energy > now.energy; ++half) {
      next = 0.5 * (y + next);
      then = pushAt(next);
    }
    y = next;
    now = then;
    if (isSettled) break;
  }
  return {now.planes, y};
}

template <int Capacity>
typename HalfSpaces<Capacity>::Shared HalfSpaces<Capacity>::settleFrom(Set planes) noexcept {
  const Vector3 y = balance(planes);
  return pushAt(y).planes == planes ? Shared{planes, y} : settle(y);
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
  const Shared rough = settle((1 - 2 * kGive) * (guess - p));
  std::array<double, Capacity> asked;
  for (std::size_t i = 0; i < size(); ++i) {
    asked[i] = missing_[i];
    missing_[i] += depth_[i];
  }
  Shared shared = settleFrom(rough.planes);
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
Vector3 HalfSpaces<Capacity>::nearest(const Vector3& p, const Vector3& guess) noexcept {
  const Shared shared = shareOut(p, guess);
  const Set others = butFirst(shared.planes);
  if (others == 0 && (count == 1 || allHold(shared.way))) return p + shared.way;
  if (others != 0 && butFirst(others) == 0) {
    const std::size_t i = firstOf(shared.planes), j = firstOf(others);
    const auto edge = nearestOnEdge(normal[i], missing_[i], normal[j], missing_[j]);
    if (edge && allHold(*edge)) return p + *edge;
  }
  return p + nearestCorner({normal.data(), size()}, {missing_.data(), size()}).value_or(shared.way);
}

}  // namespace haptiv
