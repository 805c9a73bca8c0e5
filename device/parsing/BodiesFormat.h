#pragma once

#include "device/described/ArmBodies.h"
#include "device/parsing/TomlValues.h"

namespace haptiv {

/// The links of [bodies] as rigid bodies: [[bodies.link]] for each of the arm's joints, joint 1 first.
/// Throws as TomlValues does; what no body of matter can be is refused.
ArmBodies readBodies(const TomlValues& toml, const toml::node& node, int joints);

}  // namespace haptiv
