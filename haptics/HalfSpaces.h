#pragma once

#include <Eigen/LU>
#include <array>
#include <bit>
#include <cstdint>

#include "device/types.h"

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

  /// Nearest point to p that is in all of them: p + sum of share * normal.
  ///
  /// Where the planes are (almost) parallel, infinitely many shares lead to one point, and a plane that comes into play
  /// would step in with all of its share. So each plane gives way a little: the shares s >= 0 are those of
  ///
  ///   min |y|^2 / 2 + sum max(0, r_i - n_i . y)^2 / 2d,   r_i = offset_i - n_i . p,   s_i = max(0, r_i - n_i . y) / d
  ///
  /// and are then stretched to reach the planes. They are unique, change continuously with all planes (by no more
  /// than 1 / d times as much) and do not depend on their order: planes on one spot share alike. The point is exact
  /// for one plane, for orthogonal and for coinciding ones, else within d of the way. Where no point is in all of them
  /// (a gap narrower than the ball) it is some point between.
  ///
  /// Newton's method on the planes that push: a few steps, each a 3 x 3 system. Realtime-safe: yes.
  Vector3 nearest(const Vector3& p) noexcept;

 private:
  static constexpr double kGive = 1.0 / 128;  ///< d
  static constexpr int kSteps = 20, kHalvings = 10;
  using Set = std::uint32_t;  ///< of planes, a bit each

  /// The planes that push at y, by depth_; in `energy` 2 d times the function to be minimised.
  struct Pushing {
    Set planes = 0;
    double energy = 0;
  };
  Pushing pushAt(const Vector3& y) noexcept;
  /// Where exactly these planes push.
  Vector3 balance(Set planes) const noexcept;
  Vector3 balanceOfTwo(std::size_t i, std::size_t j) const noexcept;

  std::array<double, Capacity> missing_;  ///< r
  std::array<double, Capacity> depth_;    ///< r - n . y where positive, else 0
};

template <int Capacity>
typename HalfSpaces<Capacity>::Pushing HalfSpaces<Capacity>::pushAt(const Vector3& y) noexcept {
  Pushing pushing;
  pushing.energy = kGive * y.squaredNorm();
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
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
  const double determinant = (1 + kGive) * (1 + kGive) - cosine * cosine;
  const double first = ((1 + kGive) * missing_[i] - cosine * missing_[j]) / determinant;
  const double second = ((1 + kGive) * missing_[j] - cosine * missing_[i]) / determinant;
  return first * normal[i] + second * normal[j];
}

template <int Capacity>
Vector3 HalfSpaces<Capacity>::balance(Set planes) const noexcept {
  const auto first = static_cast<std::size_t>(std::countr_zero(planes));
  const Set others = planes & (planes - 1);
  if (others == 0) return missing_[first] / (1 + kGive) * normal[first];
  if (std::has_single_bit(others)) return balanceOfTwo(first, static_cast<std::size_t>(std::countr_zero(others)));
  Matrix3 sum = kGive * Matrix3::Identity();
  Vector3 pull = Vector3::Zero();
  for (Set left = planes; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    sum += normal[i] * normal[i].transpose();
    pull += missing_[i] * normal[i];
  }
  return sum.inverse() * pull;
}

template <int Capacity>
Vector3 HalfSpaces<Capacity>::nearest(const Vector3& p) noexcept {
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) missing_[i] = offset[i] - normal[i].dot(p);
  Vector3 y = Vector3::Zero();
  Pushing now = pushAt(y);
  for (int step = 0; step < kSteps && now.planes != 0; ++step) {
    Vector3 next = balance(now.planes);
    Pushing then = pushAt(next);
    for (int half = 0; half < kHalvings && then.planes != now.planes && then.energy > now.energy; ++half) {
      next = 0.5 * (y + next);
      then = pushAt(next);
    }
    const bool isSettled = then.planes == now.planes;
    y = next;
    now = then;
    if (isSettled) break;
  }
  double squares = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    share[i] = depth_[i] / kGive;
    squares += share[i] * share[i];
  }
  const double way = y.squaredNorm();
  const double stretch = squares < way ? 1 + kGive * squares / way : 1 + kGive;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) share[i] *= stretch;
  return p + stretch * y;
}

}  // namespace haptiv
