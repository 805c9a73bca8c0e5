#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "haptics/HapticScene.h"

namespace haptiv {

/// The scene as bytes, for the session log: every double bit for bit, little-endian, with a format number.
std::vector<std::byte> toBytes(const HapticScene& scene);

/// Reads toBytes back. Throws std::runtime_error that says what is wrong at which byte; the bytes may be hostile.
HapticScene sceneFromBytes(std::span<const std::byte> bytes);

}  // namespace haptiv
