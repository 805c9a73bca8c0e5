#pragma once

#include "app/commands/Command.h"

namespace haptiv {

/// `haptiv generate maze|relief`: writes a scene made by rule and seed.
void addGenerateCommand(const Command& program);

}  // namespace haptiv
