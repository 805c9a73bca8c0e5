#pragma once

#include <optional>

#include "device/control/ControlChoice.h"
#include "device/control/ResolutionChoice.h"
#include "haptics/bytes/ByteReader.h"
#include "haptics/bytes/ByteWriter.h"

namespace haptiv {

/// What the operator chose, or that it is left to the device description. Reading throws as ByteReader does.
void write(ByteWriter& out, const std::optional<ResolutionChoice>& choice);
void write(ByteWriter& out, const std::optional<ControlChoice>& choice);
std::optional<ResolutionChoice> readResolution(ByteReader& in);
std::optional<ControlChoice> readControl(ByteReader& in);

}  // namespace haptiv
