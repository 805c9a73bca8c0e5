#include "app/editor/handles/Snap.h"

#include <algorithm>

#include "app/editor/edits/Grid.h"

namespace haptiv {
namespace {

constexpr double kStill = 1e-5;  // [m] what the dragger's single precision lets a resting side move

}  // namespace

void snapMove(const ShapeFrame& start, ShapeFrame& drag) {
  const Vector3 half = drag.alignedHalfSize().value_or(Vector3::Zero());
  const Vector3 from = start.centre();
  Vector3 centre = drag.centre();
  for (int axis = 0; axis < 3; ++axis) {
    const bool isMoved = std::abs(centre[axis] - from[axis]) > kStill;
    centre[axis] = isMoved ? Grid().snapped(centre[axis] - half[axis]) + half[axis] : from[axis];
  }
  drag.setCentre(centre);
}

Sides heldSides(const ShapeFrame& start, const ShapeFrame& drag, const Vector3& grip) {
  const Vector3 change = drag.size() - start.size();
  const Vector3 lever = start.directions().transpose() * (grip - start.centre());
  Sides sides = Sides::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(change[axis]) > kStill) sides[axis] = lever[axis] < 0 ? -1 : 1;
  }
  return sides;
}

Vector3 pullDirection(const ShapeFrame& start, const Sides& sides) {
  return (start.directions() * sides.cwiseProduct(start.size())).normalized();
}

void stretch(ShapeFrame& shape, const Sides& sides, const Vector3& pull, bool toGrid) {
  const bool isAligned = shape.alignedHalfSize().has_value();
  const Matrix3 directions = shape.directions();
  const Vector3 from = shape.size();
  Vector3 size = from;
  Vector3 centre = shape.centre();
  for (int axis = 0; axis < 3; ++axis) {
    if (sides[axis] == 0) continue;
    const Vector3 outwards = sides[axis] * directions.col(axis);
    size[axis] += outwards.dot(pull);
    if (toGrid && isAligned) {
      const double rest = outwards.dot(shape.centre()) - from[axis] / 2;
      size[axis] = Grid().snapped(rest + size[axis]) - rest;
    }
    size[axis] = std::max(size[axis], ShapeFrame::kMinSize);
    centre += outwards * (size[axis] - from[axis]) / 2;
  }
  shape.setSize(size);
  shape.setCentre(centre);
}

}  // namespace haptiv
