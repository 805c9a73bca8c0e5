#pragma once

#include <Inventor/nodes/SoSeparator.h>

#include <QString>

#include "app/editor/document/SceneDocument.h"
#include "app/editor/items/SceneItems.h"
#include "device/types.h"

namespace haptiv {

/// A wall or zone that is ready to be put into the scene; its last child is the shape.
struct NewShape {
  NodeRef<SoSeparator> node;
  QString label;
  Vector3 centre = Vector3::Zero();  ///< in W [m]
};

/// Of a usual size (a wall: as the walls that are there), on the grid, free of everything that is felt, as near to
/// the ball's home as that allows.
NewShape newShape(SceneDocument& document, SceneItem::Kind kind);

}  // namespace haptiv
