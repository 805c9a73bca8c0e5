#include "scenegraph/compiling/ShapeConversion.h"

#include <Inventor/VRMLnodes/SoVRMLBox.h>
#include <Inventor/VRMLnodes/SoVRMLCone.h>
#include <Inventor/VRMLnodes/SoVRMLCylinder.h>
#include <Inventor/VRMLnodes/SoVRMLSphere.h>
#include <Inventor/nodes/SoCone.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoCylinder.h>
#include <Inventor/nodes/SoSphere.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "scenegraph/NumberText.h"

namespace haptiv {
namespace {

/// Lengths and right angles are equal when they differ by less than this, relatively: Coin multiplies its matrices in
/// single precision, and a tenth of a millimetre in a metre is less than an encoder shows.
constexpr double kSame = 1e-4;

/// A size of a shape as its node gives it [m].
struct Size {
  const char* field = "";
  double value = 0;
};
using Sizes = std::array<Size, 3>;

/// Why sizes cannot be used; empty where they can. Zero is no error: such a shape has nothing to feel.
std::string sizeFault(const Sizes& sizes) {
  for (const Size& size : sizes) {
    if (!(size.value >= 0) || !std::isfinite(size.value)) {
      return std::string(size.field) + " is " + numberText(size.value) + ": write a positive length in metres";
    }
  }
  return {};
}

bool sameLength(double a, double b) {
  return std::abs(a - b) <= kSame * std::max(a, b);
}

bool orthogonal(const Matrix3& axes) {
  const Matrix3 products = axes.transpose() * axes;
  const Vector3 lengths = axes.colwise().norm().transpose();
  return std::abs(products(0, 1)) <= kSame * lengths(0) * lengths(1) &&
         std::abs(products(0, 2)) <= kSame * lengths(0) * lengths(2) &&
         std::abs(products(1, 2)) <= kSame * lengths(1) * lengths(2);
}

/// Whether the shape has volume; a plate as thin as a millionth of its width still has.
bool isSolid(const Matrix3& axes) {
  const Vector3 lengths = axes.colwise().norm().transpose();
  return std::abs(axes.determinant()) > 1e-6 * lengths.prod();
}

/// The axes of a cylinder or cone with rounding taken out: a right angle is one, and both radii are equal.
Matrix3 straighten(const Matrix3& axes) {
  const Vector3 axis = axes.col(1);
  const Vector3 along = axis.normalized();
  const double radius = 0.5 * (axes.col(0).norm() + axes.col(2).norm());
  const Vector3 first = (axes.col(0) - along * along.dot(axes.col(0))).normalized();
  Matrix3 straight;
  straight << radius * first, axis, radius * first.cross(along);
  return straight;
}

/// The shape that half extents along the local axes become; nothing where it is none of the exact ones.
std::optional<Shape> place(Shape::Kind kind, const Vector3& halfExtents, const SbMatrix& m) {
  if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1) return std::nullopt;  // a perspective part
  Shape shape;
  shape.kind = kind;
  for (int row = 0; row < 3; ++row) {
    for (int axis = 0; axis < 3; ++axis) shape.axes(row, axis) = halfExtents[axis] * m[axis][row];
    shape.centre[row] = m[3][row];
  }
  if (!shape.axes.allFinite() || !shape.centre.allFinite()) return std::nullopt;
  if ((shape.axes.colwise().norm().array() == 0).any() || !isSolid(shape.axes)) return std::nullopt;
  const double a = shape.axes.col(0).norm();
  const double b = shape.axes.col(1).norm();
  const double c = shape.axes.col(2).norm();
  const bool straight = orthogonal(shape.axes);
  if (kind == Shape::Kind::sphere) {
    if (!straight || !sameLength(a, b) || !sameLength(b, c)) return std::nullopt;
    shape.axes = Matrix3::Identity() * ((a + b + c) / 3);
  } else if (kind != Shape::Kind::box) {
    if (!straight || !sameLength(a, c)) return std::nullopt;
    shape.axes = straighten(shape.axes);
  }
  return shape;
}

/// A shape as its node gives it.
struct Solid {
  Shape::Kind kind = Shape::Kind::box;
  Sizes sizes;
  Vector3 halfExtents = Vector3::Zero();
  bool isWhole = true;  ///< all parts of it are drawn
};

ConvertedShape convert(const Solid& solid, const SbMatrix& modelMatrix) {
  const std::string fault = sizeFault(solid.sizes);
  if (!fault.empty()) return {std::nullopt, fault};
  if (!solid.isWhole) return {};
  return {place(solid.kind, solid.halfExtents, modelMatrix), {}};
}

ConvertedShape convertBox(const SbVec3f& size, const SbMatrix& m) {
  const Vector3 full(size[0], size[1], size[2]);
  return convert({Shape::Kind::box, {{{"width", full[0]}, {"height", full[1]}, {"depth", full[2]}}}, full / 2}, m);
}

ConvertedShape convertSphere(double radius, const SbMatrix& m) {
  return convert({Shape::Kind::sphere, {{{"radius", radius}}}, Vector3::Constant(radius)}, m);
}

ConvertedShape convertRound(Shape::Kind kind, double radius, double height, bool isWhole, const SbMatrix& m) {
  const char* radiusField = kind == Shape::Kind::cone ? "bottomRadius" : "radius";
  const Vector3 half(radius, height / 2, radius);
  return convert({kind, {{{radiusField, radius}, {"height", height}}}, half, isWhole}, m);
}

/// The node as one of a class, not of one that is derived from it; null where it is another. A dynamic cast takes
/// longer.
template <typename Node>
const Node* exactly(const SoNode* node) {
  return node->getTypeId() == Node::getClassTypeId() ? static_cast<const Node*>(node) : nullptr;
}

}  // namespace

ConvertedShape convertShape(const SoNode* node, const SbMatrix& m) {
  if (const auto* cube = exactly<SoCube>(node))
    return convertBox({cube->width.getValue(), cube->height.getValue(), cube->depth.getValue()}, m);
  if (const auto* box = exactly<SoVRMLBox>(node)) return convertBox(box->size.getValue(), m);
  if (const auto* sphere = exactly<SoSphere>(node)) return convertSphere(sphere->radius.getValue(), m);
  if (const auto* ball = exactly<SoVRMLSphere>(node)) return convertSphere(ball->radius.getValue(), m);
  if (const auto* c = exactly<SoCylinder>(node)) {
    const bool isWhole = c->parts.getValue() == SoCylinder::ALL;
    return convertRound(Shape::Kind::cylinder, c->radius.getValue(), c->height.getValue(), isWhole, m);
  }
  if (const auto* c = exactly<SoVRMLCylinder>(node)) {
    const bool isWhole = c->side.getValue() && c->top.getValue() && c->bottom.getValue();
    return convertRound(Shape::Kind::cylinder, c->radius.getValue(), c->height.getValue(), isWhole, m);
  }
  if (const auto* c = exactly<SoCone>(node)) {
    const bool isWhole = c->parts.getValue() == SoCone::ALL;
    return convertRound(Shape::Kind::cone, c->bottomRadius.getValue(), c->height.getValue(), isWhole, m);
  }
  if (const auto* c = exactly<SoVRMLCone>(node)) {
    const bool isWhole = c->side.getValue() && c->bottom.getValue();
    return convertRound(Shape::Kind::cone, c->bottomRadius.getValue(), c->height.getValue(), isWhole, m);
  }
  return {};
}

Vector3 transformPoint(const SbMatrix& m, const Vector3& point) {
  Vector3 result;
  for (int row = 0; row < 3; ++row) {
    result[row] = point[0] * m[0][row] + point[1] * m[1][row] + point[2] * m[2][row] + m[3][row];
  }
  return result;
}

}  // namespace haptiv
