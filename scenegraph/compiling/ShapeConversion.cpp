#include "scenegraph/compiling/ShapeConversion.h"

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
  const char* field;
  double value;
};

/// Why sizes cannot be used; empty where they can. Zero is no error: such a shape has nothing to feel.
std::string sizeFault(std::initializer_list<Size> sizes) {
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

ConvertedShape notFelt(std::string why) {
  return {std::nullopt, false, std::move(why)};
}

/// The shape that half extents along the local axes become.
ConvertedShape place(Shape::Kind kind, const Vector3& halfExtents, const SbMatrix& m) {
  if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1) {
    return notFelt("is not felt: its transform has a perspective part: use translation, rotation and scale");
  }
  Shape shape;
  shape.kind = kind;
  for (int row = 0; row < 3; ++row) {
    for (int axis = 0; axis < 3; ++axis) shape.axes(row, axis) = halfExtents[axis] * m[axis][row];
    shape.centre[row] = m[3][row];
  }
  if (!shape.axes.allFinite() || !shape.centre.allFinite()) {
    return {std::nullopt, true, "its transform is not finite: correct the numbers of the transforms before it"};
  }
  if ((shape.axes.colwise().norm().array() == 0).any() || !isSolid(shape.axes)) {
    return notFelt("is not felt: it is flat or empty: give it three extents that are not zero");
  }
  const double a = shape.axes.col(0).norm();
  const double b = shape.axes.col(1).norm();
  const double c = shape.axes.col(2).norm();
  const bool straight = orthogonal(shape.axes);
  if (kind == Shape::Kind::sphere) {
    if (!straight || !sameLength(a, b) || !sameLength(b, c)) {
      return notFelt("is not felt: its transform makes it an ellipsoid: scale it equally along x, y and z");
    }
    shape.axes = Matrix3::Identity() * ((a + b + c) / 3);
  } else if (kind != Shape::Kind::box) {
    if (!straight || !sameLength(a, c)) {
      return notFelt("is not felt: its transform makes it oval or skew: scale its x and z equally, before rotating");
    }
    shape.axes = straighten(shape.axes);
  }
  return {shape, false, {}};
}

void remarkOpen(ConvertedShape& converted) {
  if (converted.shape) converted.remark = "is felt as if it were closed: set parts to ALL to see what is felt";
}

}  // namespace

bool isExactShape(const SoNode* node) {
  for (const SoType type :
       {SoCube::getClassTypeId(), SoSphere::getClassTypeId(), SoCylinder::getClassTypeId(), SoCone::getClassTypeId()}) {
    if (node->isOfType(type)) return true;
  }
  return false;
}

ConvertedShape convertShape(const SoNode* node, const SbMatrix& modelMatrix) {
  ConvertedShape converted;
  const auto convert = [&](Shape::Kind kind, std::initializer_list<Size> sizes, const Vector3& halfExtents) {
    const std::string fault = sizeFault(sizes);
    converted = fault.empty() ? place(kind, halfExtents, modelMatrix) : ConvertedShape{std::nullopt, true, fault};
  };
  if (const auto* cube = dynamic_cast<const SoCube*>(node)) {
    const double w = cube->width.getValue();
    const double h = cube->height.getValue();
    const double d = cube->depth.getValue();
    convert(Shape::Kind::box, {{"width", w}, {"height", h}, {"depth", d}}, Vector3(w, h, d) / 2);
  } else if (const auto* sphere = dynamic_cast<const SoSphere*>(node)) {
    const double r = sphere->radius.getValue();
    convert(Shape::Kind::sphere, {{"radius", r}}, Vector3(r, r, r));
  } else if (const auto* cylinder = dynamic_cast<const SoCylinder*>(node)) {
    const double r = cylinder->radius.getValue();
    const double h = cylinder->height.getValue();
    convert(Shape::Kind::cylinder, {{"radius", r}, {"height", h}}, Vector3(r, h / 2, r));
    if (cylinder->parts.getValue() != SoCylinder::ALL) remarkOpen(converted);
  } else if (const auto* cone = dynamic_cast<const SoCone*>(node)) {
    const double r = cone->bottomRadius.getValue();
    const double h = cone->height.getValue();
    convert(Shape::Kind::cone, {{"bottomRadius", r}, {"height", h}}, Vector3(r, h / 2, r));
    if (cone->parts.getValue() != SoCone::ALL) remarkOpen(converted);
  }
  return converted;
}

Vector3 transformPoint(const SbMatrix& m, const Vector3& point) {
  Vector3 result;
  for (int row = 0; row < 3; ++row) {
    result[row] = point[0] * m[0][row] + point[1] * m[1][row] + point[2] * m[2][row] + m[3][row];
  }
  return result;
}

}  // namespace haptiv
