#pragma once

#include "device/described/ChainGeometry.h"
#include "device/parsing/TomlValues.h"

namespace haptiv {

/// The arm of [chain]: [[chain.joint]] for each joint, from the base outwards, and [chain.end] for the wrist centre.
/// Throws as TomlValues does.
ChainGeometry readChain(const TomlValues& toml, const toml::node& node);

}  // namespace haptiv
