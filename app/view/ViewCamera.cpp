#include "app/view/ViewCamera.h"

#include <Inventor/SbLine.h>
#include <Inventor/SbViewVolume.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "scenegraph/CoinValues.h"

namespace haptiv {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kFieldOfView = 36 * kDegree;  // vertical
constexpr double kNearest = 1e-3;              // of the place looked at [m]
constexpr double kFarthest = 1e6;              // some scenes are in millimetres
constexpr double kHighest = 2;                 // the orthographic camera stands at least so high above the place [m]
constexpr double kMargin = 1.06;
const double kTan = std::tan(kFieldOfView / 2);

// As Coin's cameras draw it (ADJUST_CAMERA): upright pictures see as far to the sides as square ones.
SbViewVolume volume(const SoCamera* camera, const QSize& picture) {
  const float aspectRatio = static_cast<float>(picture.width()) / static_cast<float>(picture.height());
  SbViewVolume seen = camera->getViewVolume(aspectRatio);
  if (aspectRatio < 1) seen.scale(1 / aspectRatio);
  return seen;
}

SbVec2f normalized(const QPointF& pixel, const QSize& picture) {
  return {static_cast<float>(pixel.x() / picture.width()), static_cast<float>(1 - pixel.y() / picture.height())};
}

std::vector<Vector3> cornersIn(const SbRotation& axes, const std::vector<SbBox3f>& boxes) {
  const SbRotation toAxes = axes.inverse();
  std::vector<Vector3> corners;
  for (const SbBox3f& box : boxes) {
    const SbVec3f& low = box.getMin();
    const SbVec3f& high = box.getMax();
    for (int i = 0; i < 8 && !box.isEmpty(); ++i) {
      SbVec3f p(i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]);
      toAxes.multVec(p, p);
      corners.push_back(toEigen(p));
    }
  }
  return corners;
}

}  // namespace

ViewCamera::ViewCamera()
    : heading_(-24 * kDegree),
      elevation_(48 * kDegree),
      root_(new SoSwitch),
      perspective_(new SoPerspectiveCamera),
      orthographic_(new SoOrthographicCamera) {
  root_->addChild(perspective_);
  root_->addChild(orthographic_);
  perspective_->heightAngle = static_cast<float>(kFieldOfView);
  update();
}

void ViewCamera::setFromAbove(bool fromAbove) {
  fromAbove_ = fromAbove;
  update();
}

void ViewCamera::orbit(const QPointF& pixels, const QSize& picture) {
  if (fromAbove_) {  // goes on from where the plan was seen
    heading_ = 0;
    elevation_ = 90 * kDegree;
    fromAbove_ = false;
  }
  const double perPixel = 180 * kDegree / picture.height();
  heading_ = std::remainder(heading_ - pixels.x() * perPixel, 360 * kDegree);
  elevation_ = std::clamp(elevation_ + pixels.y() * perPixel, -89 * kDegree, 90 * kDegree);
  update();
}

void ViewCamera::pan(const QPointF& from, const QPointF& to, const QSize& picture) {
  target_ += onFocalPlane(from, picture) - onFocalPlane(to, picture);
  update();
}

void ViewCamera::zoom(double factor, const Vector3& p_W) {
  const double closer = std::clamp(distance_ / factor, kNearest, kFarthest) / distance_;
  target_ = p_W + (target_ - p_W) * closer;
  distance_ *= closer;
  update();
}

// In the camera's axes, z towards the eye: the eye sees a point to its right if x - eye.x <= tan (eye.z - z), and so to
// the other sides. From above, where rays are parallel, depths count for nothing.
void ViewCamera::fit(const std::vector<SbBox3f>& boxes, double aspectRatio) {
  const double tanUp = kTan * std::max(1.0, 1 / aspectRatio);  // Coin widens the view of upright pictures
  const Eigen::Vector2d tan(tanUp * aspectRatio, tanUp);
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  Eigen::Vector2d most = Eigen::Vector2d::Constant(kNone);   // to the right and up
  Eigen::Vector2d least = Eigen::Vector2d::Constant(kNone);  // to the left and down
  double sumOfDepths = 0;
  int count = 0;
  for (const Vector3& p : cornersIn(orientation(), boxes)) {
    const Eigen::Vector2d depth = fromAbove_ ? Eigen::Vector2d::Zero() : Eigen::Vector2d(tan * p.z());
    most = most.cwiseMax(p.head<2>() + depth);
    least = least.cwiseMax(depth - p.head<2>());
    sumOfDepths += p.z();
    ++count;
  }
  if (count == 0) return;
  const double depth = sumOfDepths / count;
  const double eye = (most + least).cwiseQuotient(2 * tan).maxCoeff() * kMargin;
  distance_ = std::clamp(fromAbove_ ? eye : eye - depth, kNearest, kFarthest);
  const Eigen::Vector2d middle = (most - least) / 2;
  SbVec3f target;
  orientation().multVec(toCoin({middle.x(), middle.y(), depth}), target);
  target_ = toEigen(target);
  update();
}

void ViewCamera::lookLike(const SoCamera& camera) {
  const auto turned = [&](const SbVec3f& axis) {
    SbVec3f result;
    camera.orientation.getValue().multVec(axis, result);
    return toEigen(result);
  };
  const Vector3 forward = turned({0, 0, -1});
  const Vector3 up = turned({0, 1, 0});
  double distance = camera.focalDistance.getValue();
  const auto* orthographic = dynamic_cast<const SoOrthographicCamera*>(&camera);
  if (orthographic) distance = orthographic->height.getValue() / (2 * kTan);
  const Vector3 target = toEigen(camera.position.getValue()) + camera.focalDistance.getValue() * forward;
  if (!target.allFinite() || !up.allFinite() || !(distance > 0) || !std::isfinite(distance)) return;
  fromAbove_ = false;
  target_ = target;
  distance_ = std::clamp(distance, kNearest, kFarthest);
  elevation_ = std::clamp(std::asin(std::clamp(-forward.z(), -1.0, 1.0)), -89 * kDegree, 90 * kDegree);
  // Straight down the upper side of the picture tells the heading.
  const Vector3& ahead = std::abs(forward.z()) > 0.999 ? up : forward;
  heading_ = std::atan2(-ahead.x(), ahead.y());
  update();
}

ViewRay ViewCamera::ray(const QPointF& pixel, const QSize& picture) const {
  SbLine line;
  volume(active(), picture).projectPointToLine(normalized(pixel, picture), line);
  return {toEigen(line.getPosition()), toEigen(line.getDirection()).normalized()};
}

Vector3 ViewCamera::onFocalPlane(const QPointF& pixel, const QSize& picture) const {
  const ViewRay r = ray(pixel, picture);
  return r.origin + r.direction * ((target_ - r.origin).dot(direction()) / r.direction.dot(direction()));
}

QPointF ViewCamera::toPixel(const Vector3& p_W, const QSize& picture) const {
  SbVec3f screen;
  volume(active(), picture).projectToScreen(toCoin(p_W), screen);
  return {screen[0] * static_cast<double>(picture.width()), (1 - static_cast<double>(screen[1])) * picture.height()};
}

double ViewCamera::metresPerPixel(const Vector3& p_W, const QSize& picture) const {
  const double ratio = static_cast<double>(picture.width()) / picture.height();
  const double atFocus = 2 * distance_ * kTan * std::max(1.0, 1 / ratio) / picture.height();
  if (fromAbove_) return atFocus;
  return atFocus * std::max(kNearest, distance_ + (p_W - target_).dot(direction())) / distance_;
}

Vector3 ViewCamera::direction() const {
  SbVec3f forward(0, 0, -1);
  orientation().multVec(forward, forward);
  return toEigen(forward);
}

SoCamera* ViewCamera::active() const {
  return fromAbove_ ? static_cast<SoCamera*>(orthographic_) : static_cast<SoCamera*>(perspective_);
}

SbRotation ViewCamera::orientation() const {
  if (fromAbove_) return SbRotation::identity();
  return SbRotation({1, 0, 0}, static_cast<float>(90 * kDegree - elevation_)) *
         SbRotation({0, 0, 1}, static_cast<float>(heading_));
}

void ViewCamera::update() {
  const double away = fromAbove_ ? std::max(distance_, kHighest) : distance_;
  SoCamera* camera = active();
  setIfChanged(camera->position, toCoin(target_ - direction() * away));
  setIfChanged(camera->orientation, orientation());
  setIfChanged(camera->focalDistance, static_cast<float>(away));
  setIfChanged(camera->nearDistance, static_cast<float>(0.02 * away));
  setIfChanged(camera->farDistance, static_cast<float>(5 + 10 * away));
  setIfChanged(orthographic_->height, static_cast<float>(2 * distance_ * kTan));
  setIfChanged(root_->whichChild, fromAbove_ ? 1 : 0);
}

}  // namespace haptiv
