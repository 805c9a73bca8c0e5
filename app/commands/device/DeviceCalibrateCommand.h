#pragma once

#include "app/commands/Command.h"

namespace haptiv {

/// `haptiv device calibrate`: bias and matrix of the handle's sensor.
void addDeviceCalibrateCommand(const Command& device);

}  // namespace haptiv
