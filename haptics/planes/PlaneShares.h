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
  using Settled = GivingPlanes::Settled;

  /// @param normals  unit
  /// @param missing  r: how far each plane leaves out the origin [m]; at least one does
  /// @param shares   out; zero at first [m]
  PlaneShares(std::span<const Vector3> normals, std::span<const double> missing, std::span<double> shares) noexcept
      : normal_(normals), missing_(missing), share_(shares) {}

  /// Which push, and where to. In closed form where up to three push, and which they are shows at the guess.
  /// @param guess  where it may be; saves steps, and does not change the shares
  [[gnu::always_inline]] inline Settled shareOut(const Vector3& guess) noexcept {
    constexpr int kGuesses = 3;
    const Vector3 start = (1 - 2 * kGive) * guess;
    PlaneSet likely = pushingAt(start);
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
  Settled shareOneAfterTheOther(const Settled& guess) noexcept;

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
  const auto pushingBy = [&](const typename PushingPlanes<Size>::Each& shares, Vector3& way) {
    PlaneSet pushing = 0;
    for (std::size_t k = 0; k < Size; ++k) {
      way += shares[k] * normals[k];
      pushing |= static_cast<PlaneSet>(shares[k] > 0) << of[k];
    }
    return normal_.size() > Size ? pushing | (pushingAt(way) & ~guess) : pushing;
  };
  Vector3 firstWay = Vector3::Zero(), way = Vector3::Zero();
  const PlaneSet pushingFirst = pushingBy(planes.roughShares(asked), firstWay);
  if (pushingFirst != guess) {
    guess = pushingFirst;
    return std::nullopt;
  }
  const auto second = planes.shares(asked);
  if (pushingBy(second, way) != guess) return std::nullopt;
  const auto squares = planes.squaresOf(second);
  const double longer = stretchOf(squares.shares, squares.way);
  for (std::size_t k = 0; k < Size; ++k) share_[of[k]] = longer * second[k];
  return Settled{guess, longer * way};
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
  return Settled{guess, way};
}

}  // namespace haptiv
