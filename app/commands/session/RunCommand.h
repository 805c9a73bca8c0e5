#pragma once

#include "app/commands/Command.h"

namespace haptiv {

/// `haptiv run`: a session without a window. kNotSo where the scene has errors or a fault stopped the arm.
void addRunCommand(const Command& program);

}  // namespace haptiv
