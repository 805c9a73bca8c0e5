#include "app/view/ellipsoids/DexterityFigure.h"

#include "device/redundancy/criterion/Criterion.h"

namespace haptiv {

SbColor DexterityFigure::colorOf(Manipulability which) {
  return which == Manipulability::translational ? SbColor(0.96F, 0.80F, 0.10F) : SbColor(0.42F, 0.22F, 0.70F);
}

DexterityFigure::DexterityFigure()
    : root_(new SoSeparator),
      ellipsoids_{ManipulabilityEllipsoid(colorOf(Manipulability::translational)),
                  ManipulabilityEllipsoid(colorOf(Manipulability::rotational))} {
  root_->renderCaching = SoSeparator::OFF;
  root_->boundingBoxCaching = SoSeparator::OFF;
  for (const ManipulabilityEllipsoid& each : ellipsoids_) root_->addChild(each.root());
}

void DexterityFigure::setUp(const DevicePlacement& placement, const DeviceDescription& description) {
  placement_ = placement;
  kinematics_ = ArmKinematics(description);
}

void DexterityFigure::show(const Vector3& p_WT, const JointVector& q) {
  p_WT_ = p_WT;
  q_ = q;
  draw();
}

void DexterityFigure::setVisible(Manipulability which, bool visible) {
  of(which).setVisible(visible);
  draw();
}

void DexterityFigure::draw() {
  const bool any = ellipsoids_[0].isVisible() || ellipsoids_[1].isVisible();
  if (!any || !q_.allFinite()) return;
  const Jacobian J = kinematics_.jacobian(q_);
  const auto drawOne = [this](Manipulability which, const Dexterity& dexterity, double metresPerUnit) {
    if (!of(which).isVisible()) return;
    of(which).show(p_WT_, placement_.rotation * dexterity.axes, placement_.scale * metresPerUnit * dexterity.sigma);
  };
  drawOne(Manipulability::translational, translationalDexterity(J), kMetresPerSpeed);
  drawOne(Manipulability::rotational, rotationalDexterity(J), kMetresPerTurning);
}

}  // namespace haptiv
