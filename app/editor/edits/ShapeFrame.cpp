#include "app/editor/edits/ShapeFrame.h"

#include <Inventor/SbViewportRegion.h>
#include <Inventor/actions/SoGetMatrixAction.h>
#include <Inventor/nodes/SoCone.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoCylinder.h>
#include <Inventor/nodes/SoSphere.h>

#include <cmath>

#include "app/editor/items/ShapeUnit.h"
#include "scenegraph/CoinValues.h"

namespace haptiv {
namespace {

constexpr double kAligned = 1e-4;  // how far from an axis a unit vector may be: 0.1 mm on a metre

Eigen::Quaterniond toQuaternion(const SbRotation& rotation) {
  const float* q = rotation.getValue();
  return Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized();
}

/// Inventor's matrices act on rows.
Eigen::Affine3d toAffine(const SbMatrix& matrix) {
  Eigen::Affine3d affine = Eigen::Affine3d::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) affine(row, column) = matrix[column][row];
  }
  return affine;
}

/// Rid of the rounding of single precision where nothing stands in between.
Eigen::Affine3d tidied(const Eigen::Affine3d& affine) {
  return affine.isApprox(Eigen::Affine3d::Identity(), 1e-5) ? Eigen::Affine3d::Identity() : affine;
}

std::optional<Vector3> dimensionsOf(const SoNode& node) {
  if (const auto* cube = dynamic_cast<const SoCube*>(&node)) {
    return Vector3(cube->width.getValue(), cube->height.getValue(), cube->depth.getValue());
  }
  if (const auto* sphere = dynamic_cast<const SoSphere*>(&node)) {
    return Vector3::Constant(2.0 * sphere->radius.getValue());
  }
  if (const auto* cylinder = dynamic_cast<const SoCylinder*>(&node)) {
    const double diameter = 2.0 * cylinder->radius.getValue();
    return Vector3(diameter, cylinder->height.getValue(), diameter);
  }
  if (const auto* cone = dynamic_cast<const SoCone*>(&node)) {
    const double diameter = 2.0 * cone->bottomRadius.getValue();
    return Vector3(diameter, cone->height.getValue(), diameter);
  }
  return std::nullopt;
}

}  // namespace

std::optional<ShapeFrame> ShapeFrame::of(const SoPath& path) {
  const SoNode* shape = path.getTail();
  const auto dimensions = dimensionsOf(*shape);
  if (!dimensions || path.getLength() < 2) return std::nullopt;
  ShapeFrame frame;
  frame.dimensions_ = *dimensions;
  frame.isSphere_ = shape->isOfType(SoSphere::getClassTypeId());
  frame.isAxial_ = shape->isOfType(SoCylinder::getClassTypeId()) || shape->isOfType(SoCone::getClassTypeId());
  frame.findOwnTransform(path);

  SoGetMatrixAction action{SbViewportRegion()};
  action.apply(const_cast<SoPath*>(&path));
  const Eigen::Affine3d shapeToWorld = toAffine(action.getMatrix());
  if (!frame.transform_) {
    frame.before_ = tidied(shapeToWorld);
    return frame;
  }
  NodeRef<SoPath> toTransform(path.copy(0, path.getLength() - 1));
  toTransform->append(frame.transformIndex_);
  action.apply(toTransform.get());
  const Eigen::Affine3d transformToWorld = toAffine(action.getMatrix());
  frame.after_ = tidied(transformToWorld.inverse() * shapeToWorld);
  frame.before_ = tidied(transformToWorld * frame.own().inverse());
  return frame;
}

void ShapeFrame::findOwnTransform(const SoPath& path) {
  SoNode* parent = path.getNodeFromTail(1);
  parent_ = static_cast<SoGroup*>(parent);
  shapeIndex_ = path.getIndexFromTail(0);
  if (!standsAlone(path)) return;
  for (int i = shapeIndex_ - 1; i >= 0 && !transform_; --i) {
    SoNode* child = parent_->getChild(i);
    if (!child->isOfType(SoTransform::getClassTypeId())) continue;
    transform_ = static_cast<SoTransform*>(child);
    transformIndex_ = i;
  }
  if (!transform_) return;
  pivot_ = Eigen::Translation3d(toEigen(transform_->center.getValue()));
  scaleOrientation_ = toQuaternion(transform_->scaleOrientation.getValue());
  setValue(TransformValue::of(*transform_));
}

TransformValue ShapeFrame::value() const {
  TransformValue value;
  value.translation = toCoin(translation_);
  const bool isTurned = !(rotation_.coeffs() == toQuaternion(asRead_.rotation).coeffs());
  value.rotation = asRead_.rotation;  // to the bit, unless it is to change
  if (isTurned)
    value.rotation = SbRotation(static_cast<float>(rotation_.x()), static_cast<float>(rotation_.y()),
                                static_cast<float>(rotation_.z()), static_cast<float>(rotation_.w()));
  value.scaleFactor = toCoin(scale_);
  return value;
}

void ShapeFrame::setValue(const TransformValue& value) {
  asRead_ = value;
  translation_ = toEigen(value.translation);
  rotation_ = toQuaternion(value.rotation);
  scale_ = toEigen(value.scaleFactor);
}

Eigen::Affine3d ShapeFrame::own() const {
  return Eigen::Translation3d(translation_) * pivot_ * rotation_ * scaleOrientation_ * Eigen::Scaling(scale_) *
         scaleOrientation_.conjugate() * pivot_.inverse();
}

Vector3 ShapeFrame::centre() const {
  return toWorld().translation();
}

Vector3 ShapeFrame::size() const {
  return toWorld().linear().colwise().norm().transpose().cwiseProduct(dimensions_);
}

Matrix3 ShapeFrame::directions() const {
  return toWorld().linear().colwise().normalized();
}

double ShapeFrame::yaw() const {
  const Matrix3 axes = directions();
  if (axes.col(0).head<2>().norm() > 0.1) return std::atan2(axes(1, 0), axes(0, 0));
  return std::atan2(-axes(0, 1), axes(1, 1));  // the x axis is upright: the y axis tells
}

std::optional<Vector3> ShapeFrame::alignedHalfSize() const {
  const Matrix3 axes = toWorld().linear() * dimensions_.asDiagonal();
  const Matrix3 directions = axes.colwise().normalized().cwiseAbs();
  for (int i = 0; i < 3; ++i) {
    if (directions.col(i).maxCoeff() < 1 - kAligned) return std::nullopt;
  }
  return Vector3(0.5 * axes.cwiseAbs().rowwise().maxCoeff());
}

void ShapeFrame::setCentre(const Vector3& centre) {
  translation_ += before_.linear().inverse() * (centre - this->centre());
}

void ShapeFrame::setSize(const Vector3& size) {
  const Vector3 centre = this->centre();
  const Vector3 now = this->size();
  Vector3 ratio = size.cwiseMax(kMinSize).cwiseQuotient(now);
  const auto mostChanged = [&](int a, int b) { return std::abs(ratio[a] - 1) >= std::abs(ratio[b] - 1) ? a : b; };
  if (isSphere_) ratio.setConstant(ratio[mostChanged(mostChanged(0, 1), 2)]);
  if (isAxial_) ratio[0] = ratio[2] = ratio[mostChanged(0, 2)];
  scale_ = scale_.cwiseAbs().cwiseProduct(ratio);
  setCentre(centre);
}

void ShapeFrame::setYaw(double yaw) {
  const Vector3 centre = this->centre();
  const Matrix3 before = before_.linear();
  const Matrix3 turn = Eigen::AngleAxisd(yaw - this->yaw(), Vector3::UnitZ()).toRotationMatrix();
  rotation_ = Eigen::Quaterniond(Matrix3(before.inverse() * turn * before) * rotation_.toRotationMatrix()).normalized();
  setCentre(centre);
}

}  // namespace haptiv
