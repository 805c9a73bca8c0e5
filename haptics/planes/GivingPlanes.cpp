#include "haptics/planes/GivingPlanes.h"

#include <Eigen/LU>
#include <algorithm>

#include "haptics/planes/PushingPlanes.h"

namespace haptiv {

/// The planes that push at y, each with its share.
PlaneSet GivingPlanes::pushAt(const Vector3& y) const noexcept {
  PlaneSet pushing = 0;
  for (std::size_t i = 0; i < normal.size(); ++i) {
    const double depth = missing[i] - normal[i].dot(y);
    share[i] = std::max(depth, 0.0) / give;
    pushing |= static_cast<PlaneSet>(depth > 0) << i;
  }
  return pushing;
}

/// Twice the function to be minimised.
double GivingPlanes::energyAt(const Vector3& y) const noexcept {
  double energy = give * y.squaredNorm();
  for (std::size_t i = 0; i < normal.size(); ++i) {
    const double depth = std::max(missing[i] - normal[i].dot(y), 0.0);
    energy += depth * depth;
  }
  return energy;
}

/// Where exactly these planes push.
Vector3 GivingPlanes::balance(PlaneSet planes) const noexcept {
  Matrix3 sum = give * Matrix3::Identity();
  Vector3 pull = Vector3::Zero();
  for (; planes != 0; planes &= planes - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(planes));
    sum += normal[i] * normal[i].transpose();
    pull += missing[i] * normal[i];
  }
  return sum.inverse() * pull;
}

GivingPlanes::Settled GivingPlanes::settleByNewton(const Vector3& guess) const noexcept {
  constexpr int kSteps = 20, kHalvings = 10;
  Settled now{pushAt(guess), guess};
  for (int step = 0; step < kSteps; ++step) {
    Vector3 next = balance(now.pushing);
    PlaneSet then = pushAt(next);
    if (then == now.pushing) return {then, next};
    const double energy = energyAt(now.way);
    for (int half = 0; half < kHalvings && then != now.pushing && energyAt(next) > energy; ++half) {
      next = 0.5 * (now.way + next);
      then = pushAt(next);
    }
    now = {then, next};
  }
  return now;
}

template <std::size_t Size>
bool GivingPlanes::settleAsGuessed(Settled& guess) const noexcept {
  const std::array<std::size_t, Size> of = membersOf<Size>(guess.pushing);
  std::array<Vector3, Size> normals;
  std::array<double, Size> asked;
  for (std::size_t k = 0; k < Size; ++k) {
    normals[k] = normal[of[k]];
    asked[k] = missing[of[k]];
  }
  const auto shares = PushingPlanes<Size>(normals, give).shares(asked);
  guess.way.setZero();
  for (std::size_t k = 0; k < Size; ++k) guess.way += shares[k][0] * normals[k];
  const PlaneSet before = guess.pushing;
  guess.pushing = pushAt(guess.way);
  return guess.pushing == before;
}

bool GivingPlanes::settleAsGuessed(Settled& guess) const noexcept {
  switch (sizeUpToThree(guess.pushing)) {
    case 1:
      return settleAsGuessed<1>(guess);
    case 2:
      return settleAsGuessed<2>(guess);
    case 3:
      return settleAsGuessed<3>(guess);
    default:
      return false;
  }
}

GivingPlanes::Settled GivingPlanes::settle(const Settled& likely) const noexcept {
  constexpr int kGuesses = 3;
  Settled guess = likely;
  for (int i = 0; i < kGuesses; ++i) {
    if (settleAsGuessed(guess)) return guess;
  }
  return settleByNewton(likely.way);
}

}  // namespace haptiv
