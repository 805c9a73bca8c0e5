#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "haptics/planes/GivingPlanes.h"
#include "haptics/planes/PushingPlanes.h"

namespace haptiv {

/// How planes share in pushing a point out from the origin: the law is HalfSpaces'. Realtime-safe: yes.
class PlaneShares {
 public:
  /// Which push, and where to.
  struct Settled {
    PlaneSet pushing = 0;
    bool isRight = true;     ///< else these only push the first time
    bool isNearest = false;  ///< `way` leads to the nearest point that is in all; else where the shares do
    Vector3 way = Vector3::Zero();
  };

  /// @param normals  unit
  /// @param missing  r: how far each plane leaves out the origin [m]; at least one does
  /// @param shares   out; zero at first [m]
  /// @param largest  of the |r| [m]
  PlaneShares(std::span<const Vector3> normals, std::span<const double> missing, std::span<double> shares,
              double largest) noexcept
      : normal_(normals), missing_(missing), share_(shares), largest_(largest) {}

  /// Where it is easily seen which push, if that is where the point may come to: somewhat nearer than they give way.
  static Vector3 startAt(const Vector3& guess) noexcept { return (1 - 2.5 * kGive) * guess; }

  /// In closed form where up to three push, and which they are shows at the start.
  /// @param likely  which leave out the start
  /// @param start   saves steps, and does not change the shares
  [[gnu::always_inline]] inline Settled shareOut(PlaneSet likely, const Vector3& start) noexcept {
    constexpr int kGuesses = 3;
    if (likely == 0) likely = pushingAt(Vector3::Zero());
    for (int i = 0; i < kGuesses; ++i) {
      const Settled shared = shareAmong(likely);
      if (shared.isRight) return shared;
      if (shared.pushing == likely) break;
      likely = shared.pushing;
    }
    return shareOneAfterTheOther({likely, start});
  }

 private:
  static constexpr double kGive = 1.0 / 128;  ///< d
  static constexpr double kWide = 1e-3;       ///< spread of planes that are far from parallel
  static constexpr double kRounding = 1e-12;

  PlaneSet pushingAt(const Vector3& y) const noexcept {
    PlaneSet pushing = 0;
    for (std::size_t i = 0; i < normal_.size(); ++i) {
      pushing |= static_cast<PlaneSet>(missing_[i] > normal_[i].dot(y)) << i;
    }
    return pushing;
  }

  /// Which planes leave out where the shares lead to, the first time and the second, and how far one of them leaves
  /// out where the firm ones do [m].
  struct Left {
    PlaneSet first = 0, second = 0;
    double firm = 0;
  };
  Left leftBy(const std::array<Pair, 3>& firstAndFirm, const Vector3& second) const noexcept {
    Left left;
    for (std::size_t i = 0; i < normal_.size(); ++i) {
      const Vector3& n = normal_[i];
      const Pair along = firstAndFirm[0] * n.x() + firstAndFirm[1] * n.y() + firstAndFirm[2] * n.z();
      left.first |= static_cast<PlaneSet>(missing_[i] > along[0]) << i;
      left.second |= static_cast<PlaneSet>(missing_[i] > n.dot(second)) << i;
      left.firm = std::max(left.firm, missing_[i] - along[1]);
    }
    return left;
  }

  /// Where just the guessed planes push, the first time and the second.
  [[gnu::always_inline]] inline Settled shareAmong(PlaneSet guess) noexcept {
    switch (sizeUpToThree(guess)) {
      case 1:
        return giveToOne(guess);
      case 2:
        return shareAmong<2>(guess);
      case 3:
        return shareAmong<3>(guess);
      default:
        return {guess, false};
    }
  }
  template <std::size_t Size>
  [[gnu::always_inline]] inline Settled shareAmong(PlaneSet guess) noexcept;
  [[gnu::always_inline]] inline Settled giveToOne(PlaneSet guess) noexcept;
  /// The same where other planes push the second time, or it is harder to find out which.
  [[gnu::noinline]] Settled shareOneAfterTheOther(const GivingPlanes::Settled& guess) noexcept;

  /// How much longer the shares have to be to reach the planes.
  /// @param squares  sum of the shares' [m^2]
  /// @param way      square of where they lead to [m^2]
  static double stretchOf(double squares, double way) noexcept {
    const double give = kGive * std::min(squares, way);
    return (way + give) * (way + give) / (way * (way + 2 * give));
  }

  std::span<const Vector3> normal_;
  std::span<const double> missing_;
  std::span<double> share_;
  double largest_;
};

template <std::size_t Size>
PlaneShares::Settled PlaneShares::shareAmong(PlaneSet guess) noexcept {
  const std::array<std::size_t, Size> of = membersOf<Size>(guess);
  std::array<Vector3, Size> normals;
  std::array<double, Size> asked;
  for (std::size_t k = 0; k < Size; ++k) {
    normals[k] = normal_[of[k]];
    asked[k] = missing_[of[k]];
  }
  const PushingPlanes<Size> planes(normals, kGive);
  const auto first = planes.shares(asked);
  const auto second = planes.nearerShares(asked);
  std::array<Pair, 3> firstWay{};
  Vector3 way = Vector3::Zero();
  PlaneSet pushingFirst = 0, pushing = 0;
  bool isFirm = planes.spread() > kWide;
  for (std::size_t k = 0; k < Size; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) firstWay[axis] += first[k] * normals[k][static_cast<int>(axis)];
    way += second[k] * normals[k];
    pushingFirst |= static_cast<PlaneSet>(first[k][0] > 0) << of[k];
    pushing |= static_cast<PlaneSet>(second[k] > 0) << of[k];
    isFirm = isFirm & (first[k][1] >= 0);
  }
  const Left left = leftBy(firstWay, way);
  pushingFirst |= left.first & ~guess;
  pushing |= left.second & ~guess;
  if (pushingFirst != guess || pushing != guess) return {pushingFirst, false};
  double squares = 0;
  for (const double share : second) squares += share * share;
  const double longer = stretchOf(squares, way.squaredNorm());
  for (std::size_t k = 0; k < Size; ++k) share_[of[k]] = longer * second[k];
  if (isFirm && left.firm <= kRounding * largest_) {
    return {guess, true, true, {firstWay[0][1], firstWay[1][1], firstWay[2][1]}};
  }
  return {guess, true, false, longer * way};
}

/// One is exact, but to the others, who see it give way.
PlaneShares::Settled PlaneShares::giveToOne(PlaneSet guess) noexcept {
  constexpr double kFirst = 1 / (1 + kGive), kSecond = (1 + 2 * kGive) * kFirst * kFirst;
  const std::size_t one = membersOf<1>(guess)[0];
  const Vector3 way = missing_[one] * normal_[one];
  const PlaneSet pushingFirst = pushingAt(kFirst * way);
  const bool isRight = pushingFirst == guess && pushingAt(kSecond * way) == guess;
  if (!isRight) return {pushingFirst, false};
  share_[one] = missing_[one];
  return {guess, true, (pushingAt(way) & ~guess) == 0, way};
}

}  // namespace haptiv
