#pragma once

#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTransform.h>

#include <utility>
#include <vector>

#include "device/kinematics/ArmKinematics.h"
#include "haptics/scene/HapticScene.h"
#include "scenegraph/NodeRef.h"

namespace haptiv {

/// The arm as solids. VISHARD10: four flat SCARA links hanging from a post, the column down to the plane of the hand,
/// and the lifting links with the rod to the ball. Any other chain: tubes from joint to joint, and housings along the
/// axes. A parallel arm: its legs. Slim and translucent, for it comes from above and must not hide the ball. Thread:
/// GUI.
class ArmFigure {
 public:
  ArmFigure();

  SoSeparator* root() const { return root_.get(); }
  void setUp(const DevicePlacement& placement, const DeviceDescription& description);
  void show(const JointVector& q);
  /// 0: solid, 1: not seen
  void setTransparency(double transparency);

 private:
  void build();
  void addLinks(int count);
  void addJoints(int count);
  SoMaterial* addMaterial(SoSeparator* parent, const SbColor& color);
  SoTransform* addSolid(SoSeparator* parent, SoNode* shape);
  bool isScara() const { return kinematics_.vishard10() != nullptr; }
  bool isDelta() const { return kinematics_.delta() != nullptr; }
  void showLinks(const ArmSkeleton& p_W) const;
  void showScaraJoints(const ArmSkeleton& p_W) const;
  void showChainJoints(const ArmSkeleton& p_W, const JointVector& q) const;
  void place(SoTransform* solid, const Vector3& from, const Vector3& to, const Vector3& side) const;
  void placeHousing(SoTransform* housing, const Vector3& p_W, const Vector3& axis, double height,
                    const Vector3& side) const;

  ArmKinematics kinematics_{DeviceDescription{}};
  DevicePlacement placement_;
  std::pair<int, int> built_;  // what the solids are for: which kind of arm, how many points in the skeleton
  NodeRef<SoSeparator> root_;
  SoSeparator* castings_;
  SoSeparator* tubes_;
  std::vector<SoMaterial*> materials_;
  SoTransform* post_ = nullptr;
  std::vector<SoTransform*> links_;
  std::vector<SoTransform*> joints_;
};

}  // namespace haptiv
