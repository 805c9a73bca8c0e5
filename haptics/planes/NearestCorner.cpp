#include "haptics/planes/NearestCorner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace haptiv {
namespace {

/// Planes that meet in a face, an edge or a corner, and the point of it next to the origin.
struct Meeting {
  std::array<std::size_t, 3> plane{};
  std::size_t count = 0;
  Vector3 place = Vector3::Zero();
};

class Planes {
 public:
  Planes(std::span<const Vector3> normals, std::span<const double> offsets) noexcept
      : normals_(normals), offsets_(offsets) {
    for (const double offset : offsets) size_ = std::max(size_, std::abs(offset));
  }

  /// The plane that leaves `place` out most; none where all have it inside.
  std::optional<std::size_t> mostViolated(const Vector3& place) const noexcept {
    std::optional<std::size_t> worst;
    double most = tolerance(place);
    for (std::size_t i = 0; i < normals_.size(); ++i) {
      const double violation = offsets_[i] - normals_[i].dot(place);
      if (!(violation > most)) continue;
      most = violation;
      worst = i;
    }
    return worst;
  }

  /// The nearest point for the planes of `old` and a new one: on the new one, and perhaps on some of the old.
  std::optional<Meeting> with(const Meeting& old, std::size_t added) const noexcept {
    const std::size_t n = old.count;
    if (const auto found = tryMeeting({{added}, 1}, old)) return found;
    for (std::size_t i = 0; i < n; ++i) {
      if (const auto found = tryMeeting({{added, old.plane[i]}, 2}, old)) return found;
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        if (const auto found = tryMeeting({{added, old.plane[i], old.plane[j]}, 3}, old)) return found;
      }
    }
    return std::nullopt;
  }

 private:
  double tolerance(const Vector3& place) const noexcept { return 1e-12 * (size_ + place.cwiseAbs().maxCoeff()); }

  /// Where all of its planes push, and the old ones have it inside.
  std::optional<Meeting> tryMeeting(Meeting meeting, const Meeting& old) const noexcept {
    const auto place = placeOf(meeting);
    if (!place) return std::nullopt;
    meeting.place = *place;
    for (std::size_t i = 0; i < old.count; ++i) {
      const std::size_t k = old.plane[i];
      if (offsets_[k] - normals_[k].dot(meeting.place) > tolerance(meeting.place)) return std::nullopt;
    }
    return meeting;
  }
  std::optional<Vector3> placeOf(const Meeting& meeting) const noexcept {
    const auto [i, j, k] = meeting.plane;
    if (meeting.count == 1) return Vector3(offsets_[i] * normals_[i]);
    if (meeting.count == 2) return nearestOnEdge(normals_[i], offsets_[i], normals_[j], offsets_[j]);
    return nearestInCorner(normals_[i], offsets_[i], normals_[j], offsets_[j], normals_[k], offsets_[k]);
  }

  std::span<const Vector3> normals_;
  std::span<const double> offsets_;
  double size_ = 0;
};

}  // namespace

std::optional<Vector3> nearestCorner(std::span<const Vector3> normals, std::span<const double> offsets) noexcept {
  constexpr int kSteps = 32;
  const Planes planes(normals, offsets);
  Meeting now;
  for (int step = 0; step < kSteps; ++step) {
    const auto worst = planes.mostViolated(now.place);
    if (!worst) return now.place;
    const auto next = planes.with(now, *worst);
    if (!next) return std::nullopt;
    now = *next;
  }
  return std::nullopt;
}

}  // namespace haptiv
