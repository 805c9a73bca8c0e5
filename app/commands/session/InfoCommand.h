#pragma once

#include "app/commands/Command.h"

namespace haptiv {

/// `haptiv info`: what a session log holds, complete or cut off.
void addInfoCommand(const Command& program);

}  // namespace haptiv
