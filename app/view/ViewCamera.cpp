#include "app/view/ViewCamera.h"

#include <Inventor/SbLine.h>
#include <Inventor/SbMatrix.h>
#include <Inventor/SbViewVolume.h>
#include <Inventor/SbViewportRegion.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/view/CoinValues.h"

namespace haptiv {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kFieldOfView = 36 * kDegree;  // vertical
constexpr double kNearest = 0.02;              // of the place looked at [m]
constexpr double kFarthest = 50;
constexpr double kHighest = 2;  // the orthographic camera stands at least so high above the place [m]
constexpr double kMargin = 1.06;
const double kTan = std::tan(kFieldOfView / 2);

SbViewportRegion region(const QSize& picture) {
  return {static_cast<short>(picture.width()), static_cast<short>(picture.height())};
}

SbViewVolume volume(SoCamera* camera, const QSize& picture) {
  SbViewportRegion ignored;
  return camera->getViewVolume(region(picture), ignored);
}

SbVec2f normalized(const QPointF& pixel, const QSize& picture) {
  return {static_cast<float>(pixel.x() / picture.width()), static_cast<float>(1 - pixel.y() / picture.height())};
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

void ViewCamera::fit(const SbBox3f& box, double aspectRatio) {
  if (box.isEmpty()) return;
  const double tanUp = kTan * std::max(1.0, 1 / aspectRatio);  // Coin widens the view of upright pictures
  const double tanAcross = tanUp * aspectRatio;
  const SbMatrix toCamera = [this] {
    SbMatrix matrix;
    matrix.setRotate(orientation().inverse());
    return matrix;
  }();
  const SbVec3f low = box.getMin() - box.getCenter();
  const SbVec3f high = box.getMax() - box.getCenter();
  double distance = kNearest;
  for (int corner = 0; corner < 8; ++corner) {
    SbVec3f p(corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1], corner & 4 ? high[2] : low[2]);
    toCamera.multVecMatrix(p, p);
    const double needed = std::max(std::abs(p[0]) / tanAcross, std::abs(p[1]) / tanUp);
    distance = std::max(distance, needed * kMargin + (fromAbove_ ? 0.0 : p[2]));
  }
  target_ = toEigen(box.getCenter());
  distance_ = std::min(distance, kFarthest);
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
