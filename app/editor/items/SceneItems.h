#pragma once

#include <Inventor/SoPath.h>
#include <Inventor/nodes/SoSeparator.h>

#include <QColor>
#include <QString>
#include <vector>

#include "scenegraph/NodeRef.h"

namespace haptiv {

/// Where a node stands: the child indices from the root on. Unlike an SoPath it costs nothing while the graph changes.
using ScenePlace = std::vector<int>;

/// Something of the scene that a user can select.
struct SceneItem {
  enum class Kind { wall, dampingZone, springZone, rubberBand, tool, device, scenery };

  Kind kind = Kind::scenery;
  ScenePlace place;
  const SoNode* node = nullptr;      ///< the shape; or the tool or device node
  const SoNode* property = nullptr;  ///< the haptic property in force at the shape; null: none precedes it
  QString label;                     ///< as written in the property
  QString name;                      ///< to be shown: the label, the DEF name, or the kind and a number
  QColor colour;

  bool operator==(const SceneItem&) const = default;
};

/// Whether items are to have label and name: in large scenes that takes most of the time.
enum class Naming { none, full };

/// The scene in traversal order. A shape that is used several times (USE) stands there several times.
std::vector<SceneItem> listScene(SoSeparator* root, Naming naming = Naming::full);

/// The item at the end of the path; null: it is none.
const SceneItem* findItem(const std::vector<SceneItem>& items, const SoPath* path);

ScenePlace placeOf(const SoPath& path);
/// Null where the graph has no such place.
NodeRef<SoPath> pathTo(SoSeparator* root, const ScenePlace& place);

/// "wall 3" for the first number that no label has yet.
QString unusedLabel(const std::vector<SceneItem>& items, const QString& stem);

/// The node's keyword in an Inventor file, such as "HapticSurface" or "Cube".
QString keyword(const SoNode& node);

}  // namespace haptiv
