#pragma once

#include <QImage>
#include <string>

#include "app/commands/scene/LoadedScene.h"
#include "haptics/tick/TickRecord.h"

namespace haptiv {

/// The scene with arm, ball and force as of this tick, 1280 x 720 pixels; needs no display.
/// Throws std::runtime_error naming what the machine lacks.
QImage drawSession(const LoadedScene& loaded, const TickRecord& record);

/// Writes a PNG, wholly or not at all; into a device or pipe, in place. Throws CommandFailure (kCouldNot) that says why
/// it could not.
void savePicture(const QImage& picture, const std::string& path);

/// Throws CommandFailure (kCouldNot) where a file of this name plainly cannot be written: known before a long session
/// rather than after it.
void requireWritable(const std::string& path);

}  // namespace haptiv
