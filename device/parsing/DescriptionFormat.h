#pragma once

#include "device/parsing/Section.h"

namespace haptiv {

/// The whole format but for schema, name, type, the chain and the bodies, for an arm of so many joints.
std::vector<Section> sectionsOf(DeviceDescription& description, int joints);

}  // namespace haptiv
