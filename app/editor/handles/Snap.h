#pragma once

#include "app/editor/ShapeFrame.h"

namespace haptiv {

/// Makes of what a dragger wants what the user means: lengths of at least ShapeFrame::kMinSize, round things round,
/// and with `toGrid` edges on the grid where the shape lies along W's axes (else its centre, as it is moved).
///
/// @param start  the shape when the drag began
/// @param drag   the shape as dragged; corrected
void snap(const ShapeFrame& start, ShapeFrame& drag, bool toGrid);

}  // namespace haptiv
