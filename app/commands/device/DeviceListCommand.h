#pragma once

#include "app/commands/Command.h"

namespace haptiv {

/// `haptiv device list`: the devices that can be driven, and the built-in descriptions.
void addDeviceListCommand(const Command& device);

}  // namespace haptiv
