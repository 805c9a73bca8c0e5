#pragma once

#include "app/editor/items/SceneItems.h"

namespace haptiv {

/// What a user can select below `root`, in traversal order. Names are the label, the DEF name or the kind; several
/// items may have the same.
std::vector<SceneItem> walkScene(SoSeparator& root, Naming naming);

}  // namespace haptiv
