#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "haptics/contact/MeshTriangle.h"
#include "haptics/index/Fetch.h"
#include "haptics/meshes/TwoTriangles.h"

namespace haptiv {

/// Triangles, and what is known of how near they are: a triangle is convex, so it is nowhere nearer than along the
/// normal of the place where it was measured last. Most need not be measured again. Realtime-safe: yes.
class KeptTriangles {
 public:
  static constexpr std::size_t kMost = 192;
  using Each = std::array<double, kMost>;

  std::size_t count() const noexcept { return count_; }
  bool hasRoomFor(std::size_t more) const noexcept { return count_ + more <= kMost; }
  const MeshTriangle& operator[](std::size_t i) const noexcept { return triangle_[i]; }

  /// Forgets all. @param origin  from where places are seen: near the triangles, so that little is lost by rounding [m]
  void clear(const Vector3& origin_W) noexcept {
    origin_ = origin_W;
    rounding_ = roundingAt(origin_W);
    count_ = 0;
  }
  /// Adds one that is nowhere nearer than `distance` along `normal`, as seen from the origin [m].
  void add(const MeshTriangle& triangle, const Vector3& normal, double distance) noexcept {
    triangle_[count_] = triangle;
    bound(count_++, normal, distance - rounding_);
  }

  /// How p_W lies to two triangles (or to one, twice); from now on their bounds are those from there.
  void measure(const HapticScene& scene, std::size_t i, std::size_t j, const Vector3& p_W, TwoDistances& two) noexcept {
    measureTwo(p_W, {triangle_[i].corners(scene), triangle_[j].corners(scene)}, two);
    for (const auto& [lane, at] : {std::pair(0, i), std::pair(1, j)}) {
      const double distance = std::sqrt(two.squared[lane]), perLength = distance > 0 ? 1 / distance : 0;
      boundFrom(p_W, at, perLength * two.awayOf(lane), distance);
    }
  }
  /// The same of one: from its nearest point to p_W.
  Vector3 measure(const HapticScene& scene, std::size_t i, const Vector3& p_W) noexcept {
    const Vector3 away = triangle_[i].away(scene, p_W);
    const double distance = away.norm();
    const Vector3 normal = distance > 0 ? Vector3(away / distance) : Vector3::Zero();
    boundFrom(p_W, i, normal, distance);
    return away;
  }

  /// Has what is needed to measure them brought from memory.
  void fetchCorners(const HapticScene& scene) const noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t k = 0; k < 3; ++k) fetch(triangle_[i].corner(scene, k));
    }
  }

  /// Lists those that may be within `reach` of p_W, by rising number; returns how many.
  std::size_t listNear(const Vector3& p_W, double reach, std::array<std::uint8_t, kMost>& list) const noexcept {
    Each least;
    boundDistances(p_W, least);
    std::size_t listed = 0;
    for (std::size_t i = 0; i < count_; ++i) {  // written in any case, and then counted or not
      list[listed] = static_cast<std::uint8_t>(i);
      listed += least[i] <= reach ? 1 : 0;
    }
    return listed;
  }

  /// No triangle is nearer to p_W than this, each [m].
  void boundDistances(const Vector3& p_W, Each& least) const noexcept {
    const Vector3 p = p_W - origin_;
    for (std::size_t i = 0; i < count_; ++i) {
      least[i] = offset_[i] + normal_[0][i] * p.x() + normal_[1][i] * p.y() + normal_[2][i] * p.z();
    }
  }

  /// From where on a ball that goes straight on may touch each [m].
  void boundStarts(const Vector3& from_W, const Vector3& direction, double radius, Each& start) const noexcept {
    boundDistances(from_W, start);
    for (std::size_t i = 0; i < count_; ++i) {
      const double approach =
          -(normal_[0][i] * direction.x() + normal_[1][i] * direction.y() + normal_[2][i] * direction.z());
      start[i] = std::max(0.0, (start[i] - radius) / std::max(approach, std::numeric_limits<double>::min()));
    }
  }

  /// The first of the smallest, found without jumps that cannot be foreseen; 0 where there is none.
  std::size_t smallest(const Each& of) const noexcept {
    double least = of[0];
    for (std::size_t i = 1; i < count_; ++i) least = of[i] < least ? of[i] : least;
    std::size_t at = 0;
    while (at + 1 < count_ && of[at] != least) ++at;
    return at;
  }

 private:
  static double roundingAt(const Vector3& p_W) noexcept { return 4e-15 * p_W.cwiseAbs().maxCoeff(); }
  /// As measured from p_W.
  void boundFrom(const Vector3& p_W, std::size_t i, const Vector3& normal, double distance) noexcept {
    bound(i, normal, distance - normal.dot(p_W - origin_) - roundingAt(p_W));
  }
  void bound(std::size_t i, const Vector3& normal, double offset) noexcept {
    for (std::size_t axis = 0; axis < 3; ++axis) normal_[axis][i] = normal[static_cast<Eigen::Index>(axis)];
    offset_[i] = offset;
  }

  Vector3 origin_ = Vector3::Zero();
  double rounding_ = 0;
  std::size_t count_ = 0;
  std::array<MeshTriangle, kMost> triangle_;
  std::array<Each, 3> normal_;  ///< by axis: |x - triangle| >= normal . (x - origin_) + offset ...
  Each offset_;                 ///< ... for all places x [m]
};

}  // namespace haptiv
