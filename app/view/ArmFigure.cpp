#include "app/view/ArmFigure.h"

#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoCylinder.h>
#include <Inventor/nodes/SoShapeHints.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "app/view/CoinValues.h"

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
constexpr float kScaraHousing = 0.05F;  // heights
constexpr float kLiftHousing = 0.04F;
const SbColor kGloss(0.30F, 0.32F, 0.34F);

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
  addLinks();
  addJoints();
  addPost();
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

void ArmFigure::addLinks() {
  for (float width : kScaraWidth) links_.push_back(addSolid(tubes_, plate(width, kScaraThickness)));
  for (float radius : kTubeRadius) links_.push_back(addSolid(tubes_, tube(radius)));
}

void ArmFigure::addJoints() {
  for (float radius : kHousingRadius) joints_.push_back(addSolid(castings_, tube(radius)));
}

void ArmFigure::addPost() {
  post_ = addSolid(castings_, tube(kHousingRadius[0] * 0.8F));
}

void ArmFigure::setUp(const DevicePlacement& placement, const LinkLengths& links) {
  placement_ = placement;
  kinematics_ = Vishard10(links);
}

void ArmFigure::show(const JointVector& q) {
  Points points = kinematics_.skeleton(q);
  for (Vector3& point : points) point = inWorld(point);
  showLinks(points);
  showJoints(points);
}

void ArmFigure::setTransparency(double transparency) {
  const auto value = static_cast<float>(transparency);
  for (SoMaterial* material : materials_) {
    if (material->transparency[0] == value) continue;
    material->transparency = value;
    material->specularColor = kGloss * (1 - value);  // or the gloss alone would whiten what is behind
  }
}

Vector3 ArmFigure::inWorld(const Vector3& p_B) const {
  return placement_.position + placement_.scale * (placement_.rotation * p_B);
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

void ArmFigure::showLinks(const Points& p_W) const {
  const Vector3 up = placement_.rotation.col(2);
  for (std::size_t i = 0; i < links_.size(); ++i) place(links_[i], p_W[i], p_W[i + 1], up);
  place(post_, p_W[0], p_W[0] + kPostLength * placement_.scale * up, placement_.rotation.col(0));
}

void ArmFigure::showJoints(const Points& p_W) const {
  const Vector3 up = placement_.rotation.col(2);
  const Vector3 rod = p_W[kWrist] - p_W[kWrist - 1];  // lies along the axes of joints 6, 7 and 8
  const Vector3 side = rod.norm() > 1e-9 ? rod.normalized() : Vector3(placement_.rotation.col(0));
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const bool lift = i > kElbow;
    const Vector3 half = lift ? side * (kLiftHousing / 2) : up * (kScaraHousing / 2);
    place(joints_[i], p_W[i] - placement_.scale * half, p_W[i] + placement_.scale * half, lift ? up : side);
  }
}

}  // namespace haptiv
