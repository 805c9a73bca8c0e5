#include "app/view/drawn/ArmFigure.h"

#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoCylinder.h>
#include <Inventor/nodes/SoShapeHints.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "haptics/scene/DeviceFrames.h"
#include "scenegraph/CoinValues.h"

namespace haptiv {
namespace {

// Where the points of Vishard10::skeleton are.
constexpr int kElbow = 5;  // joints 6, 7 and 8 come after it
constexpr int kWrist = 9;

// Looks only, [m] of the device.
constexpr float kPostLength = 0.16F;
constexpr std::array<float, 4> kScaraWidth = {0.05F, 0.045F, 0.04F, 0.035F};
constexpr float kScaraThickness = 0.024F;
constexpr std::array<float, 5> kTubeRadius = {0.013F, 0.012F, 0.010F, 0.010F, 0.006F};  // forearm .. rod to the ball
constexpr std::array<float, 9> kHousingRadius = {0.04F, 0.034F, 0.031F, 0.028F, 0.025F, 0.016F, 0.018F, 0.018F, 0.016F};
constexpr float kLegRadius = 0.003F;    // of a parallel arm
constexpr float kScaraHousing = 0.05F;  // heights
constexpr float kLiftHousing = 0.04F;
const SbColor kGloss(0.30F, 0.32F, 0.34F);

// The last one stands for all that follow.
template <std::size_t Size>
float at(const std::array<float, Size>& sizes, int i) {
  return sizes[std::min<std::size_t>(i, Size - 1)];
}

SoNode* tube(float radius) {
  auto* cylinder = new SoCylinder;
  cylinder->radius = radius;
  cylinder->height = 1;
  return cylinder;
}

SoNode* plate(float width, float thickness) {
  auto* cube = new SoCube;
  cube->width = width;
  cube->height = 1;
  cube->depth = thickness;
  return cube;
}

}  // namespace

ArmFigure::ArmFigure() : root_(new SoSeparator), castings_(new SoSeparator), tubes_(new SoSeparator) {
  root_->renderCaching = SoSeparator::OFF;
  root_->boundingBoxCaching = SoSeparator::OFF;
  auto* solid = new SoShapeHints;  // inner faces are not drawn, however translucent the arm is
  solid->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
  solid->shapeType = SoShapeHints::SOLID;
  root_->addChild(solid);
  materials_ = {addMaterial(castings_, SbColor(0.22F, 0.29F, 0.38F)),
                addMaterial(tubes_, SbColor(0.46F, 0.53F, 0.61F))};
  setUp({}, {});
}

SoMaterial* ArmFigure::addMaterial(SoSeparator* parent, const SbColor& color) {
  auto* material = new SoMaterial;
  material->diffuseColor = color;
  material->ambientColor = color * 0.5F;
  material->specularColor = kGloss;
  material->shininess = 0.6F;
  parent->addChild(material);
  root_->addChild(parent);
  return material;
}

SoTransform* ArmFigure::addSolid(SoSeparator* parent, SoNode* shape) {
  auto* separator = new SoSeparator;
  auto* place = new SoTransform;
  separator->addChild(place);
  separator->addChild(shape);
  parent->addChild(separator);
  return place;
}

// Anew where the arm is of another kind.
void ArmFigure::build() {
  const std::pair kind{isScara() ? 1 : isDelta() ? 2 : 3, kinematics_.skeleton(JointVector::Zero()).count};
  if (built_ == kind) return;
  built_ = kind;
  for (SoSeparator* group : {castings_, tubes_})
    while (group->getNumChildren() > 1) group->removeChild(1);  // all but the material
  links_.clear();
  joints_.clear();
  post_ = nullptr;
  addLinks(kind.second - 1);
  if (isDelta()) return;  // its motors are behind the base plate, and it hangs from nothing
  addJoints(isScara() ? static_cast<int>(kHousingRadius.size()) : kinematics_.jointCount());
  post_ = addSolid(castings_, tube(kHousingRadius[0] * 0.8F));
}

void ArmFigure::addLinks(int count) {
  const int plates = isScara() ? static_cast<int>(kScaraWidth.size()) : 0;
  for (int i = 0; i < plates; ++i) links_.push_back(addSolid(tubes_, plate(kScaraWidth[i], kScaraThickness)));
  for (int i = 0; i < count - plates; ++i)
    links_.push_back(addSolid(tubes_, tube(isDelta() ? kLegRadius : at(kTubeRadius, i))));
}

void ArmFigure::addJoints(int count) {
  const ArmSkeleton zero = kinematics_.skeleton(JointVector::Zero());
  const auto hidesBall = [&](int i) { return (zero.at[i] - zero.at[zero.count - 1]).norm() < kScaraHousing; };
  for (int i = 0; i < count; ++i)
    joints_.push_back(addSolid(castings_, tube(hidesBall(i) ? kTubeRadius.back() : at(kHousingRadius, i))));
}

void ArmFigure::setUp(const DevicePlacement& placement, const DeviceDescription& description) {
  placement_ = placement;
  kinematics_ = ArmKinematics(description);
  build();
}

void ArmFigure::show(const JointVector& q) {
  ArmSkeleton skeleton = kinematics_.skeleton(q);
  for (int i = 0; i < skeleton.count; ++i) skeleton.at[i] = placeInScene(placement_, skeleton.at[i]);
  showLinks(skeleton);
  if (isScara())
    showScaraJoints(skeleton);
  else
    showChainJoints(skeleton, q);
}

void ArmFigure::setTransparency(double transparency) {
  const auto value = static_cast<float>(transparency);
  for (SoMaterial* material : materials_) {
    if (material->transparency[0] == value) continue;
    material->transparency = value;
    material->specularColor = kGloss * (1 - value);  // or the gloss alone would whiten what is behind
  }
}

// The solid's y axis goes from one point to the other; its z axis is as near to `side` as it can be.
void ArmFigure::place(SoTransform* solid, const Vector3& from, const Vector3& to, const Vector3& side) const {
  const double length = (to - from).norm();
  const double scale = placement_.scale;
  setIfChanged(solid->translation, toCoin((from + to) / 2));
  setIfChanged(solid->scaleFactor, toCoin({scale, std::max(length, 1e-6), scale}));
  if (length < 1e-9) return;
  const Vector3 y = (to - from) / length;
  Vector3 x = y.cross(side);
  if (x.norm() < 1e-6) x = y.unitOrthogonal();
  x.normalize();
  const Vector3 z = x.cross(y);
  const SbMatrix axes(float(x.x()), float(x.y()), float(x.z()), 0, float(y.x()), float(y.y()), float(y.z()), 0,
                      float(z.x()), float(z.y()), float(z.z()), 0, 0, 0, 0, 1);
  setIfChanged(solid->rotation, SbRotation(axes));
}

void ArmFigure::showLinks(const ArmSkeleton& p_W) const {
  const Vector3 up = placement_.rotation.col(2);
  for (std::size_t i = 0; i < links_.size(); ++i) place(links_[i], p_W.at[i], p_W.at[i + 1], up);
  if (post_ != nullptr)
    place(post_, p_W.at[0], p_W.at[0] + kPostLength * placement_.scale * up, placement_.rotation.col(0));
}

// Half of the housing lies to either side of the joint.
void ArmFigure::placeHousing(SoTransform* housing, const Vector3& p_W, const Vector3& axis, double height,
                             const Vector3& side) const {
  const Vector3 half = axis * (placement_.scale * height / 2);
  place(housing, p_W - half, p_W + half, side);
}

void ArmFigure::showScaraJoints(const ArmSkeleton& p_W) const {
  const Vector3 up = placement_.rotation.col(2);
  const Vector3 rod = p_W.at[kWrist] - p_W.at[kWrist - 1];  // lies along the axes of joints 6, 7 and 8
  const Vector3 side = rod.norm() > 1e-9 ? rod.normalized() : Vector3(placement_.rotation.col(0));
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const bool lift = i > kElbow;
    placeHousing(joints_[i], p_W.at[i], lift ? side : up, lift ? kLiftHousing : kScaraHousing, lift ? up : side);
  }
}

void ArmFigure::showChainJoints(const ArmSkeleton& p_W, const JointVector& q) const {
  const Jacobian J = kinematics_.jacobian(q);
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Vector3 axis = placement_.rotation * J.col(static_cast<Eigen::Index>(i)).tail<3>();
    placeHousing(joints_[i], p_W.at[i], axis, kScaraHousing, axis.unitOrthogonal());
  }
}

}  // namespace haptiv
