#pragma once

#include "scenegraph/DecodePicture.h"

namespace haptiv {

/// Decodes PNG, JPEG, GIF and BMP by Qt, sampled down to 2048 pixels at most. Loads Qt's plug-ins for them, as no file
/// can be opened where it will run.
DecodePicture pictureDecoder();

}  // namespace haptiv
