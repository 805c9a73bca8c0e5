#pragma once

#include "app/commands/Command.h"

namespace haptiv {

/// `haptiv device home`: the encoders' zero, at the reference pose.
void addDeviceHomeCommand(const Command& device);

}  // namespace haptiv
