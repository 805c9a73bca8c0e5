#pragma once

#include <QIcon>

namespace haptiv {

/// The editor's own icons, drawn in plain strokes.
enum class EditorIcon { wall, dampingZone, springZone, rubberBand, makeSolid, duplicate, remove, undo, redo, grid };

QIcon editorIcon(EditorIcon icon);

}  // namespace haptiv
