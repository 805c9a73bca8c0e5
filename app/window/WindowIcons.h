#pragma once

#include <QIcon>

namespace haptiv {

/// The window's own icons, drawn in plain strokes like the editor's.
enum class WindowIcon { hand, select, fromAbove, showAll, arm, emergencyStop };

QIcon iconOf(WindowIcon icon);

}  // namespace haptiv
