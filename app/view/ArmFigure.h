#pragma once

#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTransform.h>

#include <array>
#include <vector>

#include "device/kinematics/Vishard10.h"
#include "haptics/HapticScene.h"
#include "scenegraph/NodeRef.h"

namespace haptiv {

/// VISHARD10 as solids: four flat SCARA links hanging from a post, the column down to the plane of the hand, and the
/// lifting links with the rod to the ball. Slim and translucent, for it comes from above and must not hide the ball.
/// Thread: GUI.
class ArmFigure {
 public:
  ArmFigure();

  SoSeparator* root() const { return root_.get(); }
  void setUp(const DevicePlacement& placement, const LinkLengths& links);
  void show(const JointVector& q);
  /// 0: solid, 1: not seen
  void setTransparency(double transparency);

 private:
  using Points = std::array<Vector3, 10>;
  void addPost();
  void addLinks();
  void addJoints();
  SoMaterial* addMaterial(SoSeparator* parent, const SbColor& color);
  SoTransform* addSolid(SoSeparator* parent, SoNode* shape);
  void showLinks(const Points& p_W) const;
  void showJoints(const Points& p_W) const;
  void place(SoTransform* solid, const Vector3& from, const Vector3& to, const Vector3& side) const;
  Vector3 inWorld(const Vector3& p_B) const;

  Vishard10 kinematics_{LinkLengths{}};
  DevicePlacement placement_;
  NodeRef<SoSeparator> root_;
  SoSeparator* castings_;
  SoSeparator* tubes_;
  std::vector<SoMaterial*> materials_;
  SoTransform* post_ = nullptr;
  std::vector<SoTransform*> links_;
  std::vector<SoTransform*> joints_;
};

}  // namespace haptiv
