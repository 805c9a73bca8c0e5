#pragma once

#include <QImage>

#include "scenegraph/reading/SceneFile.h"

namespace haptiv {

/// Draws a scene graph without a window and without X (EGL, surfaceless), from a camera that sees all of it from
/// above at a slant. Throws std::runtime_error naming what the machine lacks.
QImage drawOffscreen(SoNode* root, int width, int height);

}  // namespace haptiv
