#pragma once

#include <Inventor/SoPath.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTransform.h>

#include <Eigen/Geometry>
#include <optional>

#include "app/editor/commands/SetTransform.h"
#include "device/types.h"

namespace haptiv {

/// Where a shape stands and how big it is, and what its own transform must become to have it otherwise.
///
/// A shape's own transform is the SoTransform before it in a Separator that holds no other shape: changing it moves
/// this shape only. A shape without one is moved by wrapping it into such a Separator.
/// Point chain: p_W = P T L p_S, with P what precedes the own transform T, and L what stands between it and the shape.
class ShapeFrame {
 public:
  /// Nothing for nodes other than Cube, Sphere, Cylinder and Cone.
  static std::optional<ShapeFrame> of(const SoPath& path);

  SoTransform* ownTransform() const { return transform_; }  ///< null: none; or the manip that stands in for it
  SoGroup* parent() const { return parent_; }
  int transformIndex() const { return transformIndex_; }  ///< among the parent's children; -1: none
  int shapeIndex() const { return shapeIndex_; }
  bool isRound() const { return isSphere_ || isAxial_; }

  TransformValue value() const;
  void setValue(const TransformValue& value);

  Vector3 centre() const;      ///< in W [m]
  Vector3 size() const;        ///< full lengths along the shape's own axes [m]
  Matrix3 directions() const;  ///< of the shape's own axes, as unit columns in W
  double yaw() const;          ///< about W's z [rad]
  /// Half lengths along W's axes, where every own axis lies along one of them; otherwise nothing.
  std::optional<Vector3> alignedHalfSize() const;

  void setCentre(const Vector3& centre);
  /// About the centre. Lengths below kMinSize become it; what must stay round does, the most changed length decides.
  void setSize(const Vector3& size);
  void setYaw(double yaw);

  static constexpr double kMinSize = 0.005;  ///< [m], thinner walls are not felt as such

 private:
  ShapeFrame() = default;
  Eigen::Affine3d own() const;
  Eigen::Affine3d toWorld() const { return before_ * own() * after_; }
  void findOwnTransform(const SoPath& path);

  SoGroup* parent_ = nullptr;
  SoTransform* transform_ = nullptr;
  int transformIndex_ = -1;
  int shapeIndex_ = 0;
  bool isSphere_ = false;
  bool isAxial_ = false;                                  ///< round about the own y axis
  Vector3 dimensions_ = Vector3::Ones();                  ///< of the shape node itself
  Eigen::Affine3d before_ = Eigen::Affine3d::Identity();  ///< P
  Eigen::Affine3d after_ = Eigen::Affine3d::Identity();   ///< L
  Eigen::Translation3d pivot_{0, 0, 0};                   ///< the transform's `center`
  Eigen::Quaterniond scaleOrientation_ = Eigen::Quaterniond::Identity();
  TransformValue asRead_;
  Vector3 translation_ = Vector3::Zero();
  Eigen::Quaterniond rotation_ = Eigen::Quaterniond::Identity();
  Vector3 scale_ = Vector3::Ones();
};

}  // namespace haptiv
