#pragma once

#include "device/described/DeviceDescription.h"
#include "device/parsing/TomlValues.h"

namespace haptiv {

/// What single values cannot tell: that they go together and fit the counters. Throws as TomlValues does, at one of the
/// keys concerned.
void checkWhole(const TomlValues& toml, const toml::table& root, const DeviceDescription& description);

}  // namespace haptiv
