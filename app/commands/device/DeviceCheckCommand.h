#pragma once

#include "app/commands/Command.h"

namespace haptiv {

/// `haptiv device check`: an arm against the specification of the paper's Table II. kNotSo where it does not hold.
void addDeviceCheckCommand(const Command& device);

}  // namespace haptiv
