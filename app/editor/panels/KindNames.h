#pragma once

#include <QString>

#include "app/editor/items/SceneItems.h"

namespace haptiv {

/// One of a kind, as users call it: "Wall".
inline QString kindName(SceneItem::Kind kind) {
  switch (kind) {
    case SceneItem::Kind::wall:
      return "Wall";
    case SceneItem::Kind::dampingZone:
      return "Damping zone";
    case SceneItem::Kind::springZone:
      return "Spring zone";
    case SceneItem::Kind::rubberBand:
      return "Rubber band";
    case SceneItem::Kind::tool:
      return "Tool";
    case SceneItem::Kind::device:
      return "Device";
    case SceneItem::Kind::scenery:
      break;
  }
  return "Scenery";
}

/// All of a kind, as a heading: "Walls".
inline QString groupName(SceneItem::Kind kind) {
  const bool isCounted = kind == SceneItem::Kind::wall || kind == SceneItem::Kind::dampingZone ||
                         kind == SceneItem::Kind::springZone || kind == SceneItem::Kind::rubberBand;
  return isCounted ? kindName(kind) + "s" : kindName(kind);
}

}  // namespace haptiv
