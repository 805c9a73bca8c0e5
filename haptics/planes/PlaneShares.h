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
    Vector3 way = Vector3::Zero();
    Vector3 nearest = Vector3::Zero();  ///< where `isSure`: the nearest point to the origin that is in all
    bool isSure = false;
  };

  /// @param normals  unit
  /// @param missing  r: how far each plane leaves out the origin [m]; at least one does
  /// @param shares   out; zero at first [m]
  /// @param largest  of the |r| [m]
  PlaneShares(std::span<const Vector3> normals, std::span<const double> missing, std::span<double> shares,
              double largest) noexcept
      : normal_(normals), missing_(missing), share_(shares), largest_(largest) {}

  /// Where it is easily seen which push, if that is where the point may come to.
  static Vector3 startAt(const Vector3& guess) noexcept { return (1 - 2 * kGive) * guess; }

  /// In closed form where up to three push, and which they are shows at the start.
  /// @param likely  which leave out the start
  /// @param start   saves steps, and does not change the shares
  [[gnu::always_inline]] inline Settled shareOut(PlaneSet likely, const Vector3& start) noexcept {
    constexpr int kGuesses = 3;
    if (likely == 0) likely = pushingAt(Vector3::Zero());
    for (int i = 0; i < kGuesses; ++i) {
      const PlaneSet guessed = likely;
      if (const auto shared = shareAmong(likely)) return *shared;
      if (likely == guessed) break;
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

  /// Where just the guessed planes push, the first time and the second; where they do not, nothing, and the guess
  /// becomes that of the first time.
  [[gnu::always_inline]] inline std::optional<Settled> shareAmong(PlaneSet& guess) noexcept {
    switch (sizeUpToThree(guess)) {
      case 1:
        return giveToOne(guess);
      case 2:
        return shareAmong<2>(guess);
      case 3:
        return shareAmong<3>(guess);
      default:
        return std::nullopt;
    }
  }
  template <std::size_t Size>
  [[gnu::always_inline]] inline std::optional<Settled> shareAmong(PlaneSet& guess) noexcept;
  [[gnu::always_inline]] inline std::optional<Settled> giveToOne(PlaneSet& guess) noexcept;
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
std::optional<PlaneShares::Settled> PlaneShares::shareAmong(PlaneSet& guess) noexcept {
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
  PlaneSet pushingFirst = 0, pushingThen = 0;
  bool isFirm = planes.spread() > kWide;
  for (std::size_t k = 0; k < Size; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) firstWay[axis] += first[k] * normals[k][static_cast<int>(axis)];
    way += second[k] * normals[k];
    pushingFirst |= static_cast<PlaneSet>(first[k][0] > 0) << of[k];
    pushingThen |= static_cast<PlaneSet>(second[k] > 0) << of[k];
    isFirm = isFirm & (first[k][1] >= 0);
  }
  double left = 0;  // out, of the firm way
  PlaneSet othersFirst = 0, othersThen = 0;
  for (std::size_t i = 0; i < normal_.size(); ++i) {
    const Vector3& n = normal_[i];
    const Pair along = firstWay[0] * n.x() + firstWay[1] * n.y() + firstWay[2] * n.z();
    othersFirst |= static_cast<PlaneSet>(missing_[i] > along[0]) << i;
    othersThen |= static_cast<PlaneSet>(missing_[i] > n.dot(way)) << i;
    left = std::max(left, missing_[i] - along[1]);
  }
  pushingFirst |= othersFirst & ~guess;
  if (pushingFirst != guess) {
    guess = pushingFirst;
    return std::nullopt;
  }
  if ((pushingThen | (othersThen & ~guess)) != guess) return std::nullopt;
  double squares = 0;
  for (const double share : second) squares += share * share;
  const double longer = stretchOf(squares, way.squaredNorm());
  for (std::size_t k = 0; k < Size; ++k) share_[of[k]] = longer * second[k];
  const Vector3 nearest(firstWay[0][1], firstWay[1][1], firstWay[2][1]);
  return Settled{guess, longer * way, nearest, isFirm && left <= kRounding * largest_};
}

/// One is exact, but to the others, who see it give way.
std::optional<PlaneShares::Settled> PlaneShares::giveToOne(PlaneSet& guess) noexcept {
  constexpr double kFirst = 1 / (1 + kGive), kSecond = (1 + 2 * kGive) * kFirst * kFirst;
  const std::size_t one = membersOf<1>(guess)[0];
  const Vector3 way = missing_[one] * normal_[one];
  const PlaneSet pushingFirst = pushingAt(kFirst * way);
  const bool isRight = pushingFirst == guess && pushingAt(kSecond * way) == guess;
  guess = pushingFirst;
  if (!isRight) return std::nullopt;
  share_[one] = missing_[one];
  return Settled{guess, way, way, (pushingAt(way) & ~guess) == 0};
}

}  // namespace haptiv
