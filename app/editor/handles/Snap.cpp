#include "app/editor/handles/Snap.h"

#include <algorithm>

#include "app/editor/handles/Grid.h"

namespace haptiv {
namespace {

constexpr double kStill = 1e-5;  // [m] what the dragger's single precision lets a resting side move

struct Span {
  double low, high;
  double size() const { return high - low; }
};

/// One axis of a box: which of its sides were dragged, and where they come to lie.
Span snapped(const Span& start, const Span& drag, bool toGrid) {
  const bool isLowMoved = std::abs(drag.low - start.low) > kStill;
  const bool isHighMoved = std::abs(drag.high - start.high) > kStill;
  const auto onGrid = [toGrid](double value) { return toGrid ? Grid().snapped(value) : value; };
  if (!isLowMoved && !isHighMoved) return start;
  if (!isHighMoved) return {std::min(onGrid(drag.low), start.high - ShapeFrame::kMinSize), start.high};
  if (!isLowMoved) return {start.low, std::max(onGrid(drag.high), start.low + ShapeFrame::kMinSize)};
  if (std::abs(drag.size() - start.size()) < kStill) {
    const double low = onGrid(drag.low);
    return {low, low + start.size()};
  }
  const double low = onGrid(drag.low);
  return {low, std::max(onGrid(drag.high), low + ShapeFrame::kMinSize)};
}

void snapBox(const ShapeFrame& start, ShapeFrame& drag, const Vector3& startHalf, const Vector3& dragHalf,
             bool toGrid) {
  Vector3 size = start.size();
  Vector3 centre;
  for (int axis = 0; axis < 3; ++axis) {
    const double from = start.centre()[axis];
    const double to = drag.centre()[axis];
    const Span span =
        snapped({from - startHalf[axis], from + startHalf[axis]}, {to - dragHalf[axis], to + dragHalf[axis]}, toGrid);
    centre[axis] = (span.low + span.high) / 2;
    if (span.size() != 2 * startHalf[axis]) size[start.ownAxisAlong(axis)] = span.size();
  }
  drag.setValue(start.value());
  if (!size.isApprox(start.size(), 1e-9)) drag.setSize(size);
  drag.setCentre(centre);
}

}  // namespace

void snap(const ShapeFrame& start, ShapeFrame& drag, bool toGrid) {
  const auto startHalf = start.alignedHalfSize();
  const auto dragHalf = drag.alignedHalfSize();
  if (startHalf && dragHalf) return snapBox(start, drag, *startHalf, *dragHalf, toGrid);
  const bool isResized = !drag.size().isApprox(start.size(), 1e-4);
  if (isResized) {
    drag.setSize(drag.size());
  } else if (toGrid) {
    drag.setCentre(Grid().snapped(drag.centre()));
  }
}

}  // namespace haptiv
