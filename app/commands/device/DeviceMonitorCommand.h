#pragma once

#include "app/commands/Command.h"

namespace haptiv {

/// `haptiv device monitor`: what an interface board says, live, and how well the link carries it. Its drives stay off.
void addDeviceMonitorCommand(const Command& device);

}  // namespace haptiv
