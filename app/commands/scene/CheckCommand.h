#pragma once

#include "app/commands/Command.h"

namespace haptiv {

/// `haptiv check`: loads and judges a scene. kNotSo where it has errors.
void addCheckCommand(const Command& program);

}  // namespace haptiv
