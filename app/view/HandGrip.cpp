#include "app/view/HandGrip.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace haptiv {
namespace {

const double kSinFlat = std::sin(HandGrip::kFlat * std::numbers::pi / 180);

// Nothing where the ray runs along the plane or meets it behind the eye.
std::optional<Vector3> meet(const ViewRay& ray, const Vector3& point, const Vector3& normal) {
  const double slope = ray.direction.dot(normal);
  if (std::abs(slope) < 1e-6) return {};
  const double along = (point - ray.origin).dot(normal) / slope;
  if (along < 0) return {};
  return ray.origin + along * ray.direction;
}

}  // namespace

bool HandGrip::reaches(const QPointF& pixel, const QSize& picture, const Vector3& p_WT, double radius) const {
  const QPointF away = camera_.toPixel(p_WT, picture) - pixel;
  return std::hypot(away.x(), away.y()) <= radius / camera_.metresPerPixel(p_WT, picture) + kReach;
}

void HandGrip::take(const QPointF& pixel, const Vector3& p_WT) {
  held_ = true;
  upAndDown_ = false;
  taken_ = target_ = p_WT;
  restart(pixel);
}

Vector3 HandGrip::drag(const QPointF& pixel, const QSize& picture, bool upAndDown) {
  if (upAndDown != upAndDown_) {
    upAndDown_ = upAndDown;
    restart(pixel);
  }
  const Vector3 wanted = moved(pixel, picture);
  if ((wanted - taken_).norm() <= kFarthest) target_ = wanted;
  return target_;
}

void HandGrip::restart(const QPointF& pixel) {
  start_ = target_;
  startPixel_ = pixel;
}

Vector3 HandGrip::moved(const QPointF& pixel, const QSize& picture) const {
  const Vector3 look = camera_.direction();
  if (upAndDown_) {
    const double foreshortening = std::max(std::hypot(look.x(), look.y()), 0.5);  // from above, up the screen is up
    const double up = startPixel_.y() - pixel.y();
    return start_ + Vector3::UnitZ() * (up * camera_.metresPerPixel(start_, picture) / foreshortening);
  }
  const Vector3 normal = std::abs(look.z()) >= kSinFlat ? Vector3(Vector3::UnitZ()) : look;
  const auto from = meet(camera_.ray(startPixel_, picture), start_, normal);
  const auto to = meet(camera_.ray(pixel, picture), start_, normal);
  return from && to ? Vector3(start_ + *to - *from) : target_;
}

}  // namespace haptiv
