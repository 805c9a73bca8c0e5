#pragma once

#include <QImage>

#include "app/commands/scene/LoadedScene.h"
#include "haptics/tick/TickRecord.h"

namespace haptiv {

/// The scene with arm, ball and force as of this tick, 1280 x 720 pixels; needs no display.
/// Throws std::runtime_error naming what the machine lacks.
QImage drawSession(const LoadedScene& loaded, const TickRecord& record);

}  // namespace haptiv
