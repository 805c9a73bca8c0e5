#pragma once

#include "app/editor/edits/ShapeFrame.h"

namespace haptiv {

/// Brings a shape that was dragged onto the grid: its edges where it lies along W's axes, else its centre.
/// @param start  the shape when the drag began
/// @param drag   the shape as dragged; corrected
void snapMove(const ShapeFrame& start, ShapeFrame& drag);

/// Which sides of a shape the mouse holds: -1 or 1 for each of its own axes, 0 where it holds none.
using Sides = Vector3;

/// The sides that a dragger resizes: along the axes whose length has changed, on the side of the grip.
/// @param grip  where the mouse took hold, in W [m]
Sides heldSides(const ShapeFrame& start, const ShapeFrame& drag, const Vector3& grip);

/// The way those sides go when they are pulled, a unit vector in W.
Vector3 pullDirection(const ShapeFrame& start, const Sides& sides);

/// Pulls sides by a way in W [m]; those across from them rest. No length gets below ShapeFrame::kMinSize.
/// @param toGrid  the pulled sides go to the grid, where the shape lies along W's axes
void stretch(ShapeFrame& shape, const Sides& sides, const Vector3& pull, bool toGrid);

}  // namespace haptiv
