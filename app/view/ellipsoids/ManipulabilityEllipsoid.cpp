#include "app/view/ellipsoids/ManipulabilityEllipsoid.h"

#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoIndexedLineSet.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoSphere.h>

#include <Eigen/LU>
#include <algorithm>

#include "scenegraph/CoinValues.h"

namespace haptiv {
namespace {

constexpr float kTransparency = 0.45F;
constexpr double kThinnest = 0.02;    // of the largest half axis: a flat ellipsoid is still drawn
constexpr double kSmallest = 0.0005;  // [m]

// From end to end along each axis of the unit sphere.
SoSeparator* makeAxes(const SbColor& color) {
  auto* separator = new SoSeparator;
  auto* material = new SoMaterial;
  material->diffuseColor = color * 0.75F;
  auto* unlit = new SoLightModel;
  unlit->model = SoLightModel::BASE_COLOR;
  auto* style = new SoDrawStyle;
  style->lineWidth = 2;
  auto* ends = new SoCoordinate3;
  const SbVec3f points[] = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
  ends->point.setValues(0, 6, points);
  auto* lines = new SoIndexedLineSet;
  const int32_t pairs[] = {0, 1, -1, 2, 3, -1, 4, 5, -1};
  lines->coordIndex.setValues(0, 9, pairs);
  for (SoNode* node : std::initializer_list<SoNode*>{material, unlit, style, ends, lines}) separator->addChild(node);
  return separator;
}

}  // namespace

ManipulabilityEllipsoid::ManipulabilityEllipsoid(const SbColor& color)
    : root_(new SoSeparator), shown_(new SoSwitch), place_(new SoTransform) {
  root_->renderCaching = SoSeparator::OFF;
  root_->boundingBoxCaching = SoSeparator::OFF;
  auto* material = new SoMaterial;
  material->diffuseColor = color;
  material->ambientColor = color * 0.4F;
  material->transparency = kTransparency;
  auto* solid = new SoShapeHints;  // the far side is not drawn: it would shine through the near one
  solid->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
  solid->shapeType = SoShapeHints::SOLID;
  root_->addChild(shown_);
  for (SoNode* node : std::initializer_list<SoNode*>{place_, makeAxes(color), material, solid, new SoSphere})
    shown_->addChild(node);
  setVisible(false);
}

void ManipulabilityEllipsoid::setVisible(bool visible) {
  setIfChanged(shown_->whichChild, visible ? SO_SWITCH_ALL : SO_SWITCH_NONE);
}

bool ManipulabilityEllipsoid::isVisible() const {
  return shown_->whichChild.getValue() == SO_SWITCH_ALL;
}

void ManipulabilityEllipsoid::show(const Vector3& centre, const Matrix3& axes, const Vector3& halfAxes) {
  const Matrix3 turn = axes.determinant() < 0 ? Matrix3(-axes) : axes;  // the ellipsoid is the same
  const double thinnest = std::max(kThinnest * halfAxes.maxCoeff(), kSmallest);
  SbMatrix rows = SbMatrix::identity();
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 3; ++i) rows[axis][i] = static_cast<float>(turn(i, axis));
  setIfChanged(place_->translation, toCoin(centre));
  setIfChanged(place_->rotation, SbRotation(rows));
  setIfChanged(place_->scaleFactor, toCoin(halfAxes.cwiseMax(thinnest)));
}

}  // namespace haptiv
