#pragma once

#include "app/commands/Command.h"

namespace haptiv {

/// `haptiv device`: the commands about devices.
void addDeviceCommand(const Command& program);

}  // namespace haptiv
