#pragma once

#include "app/commands/Command.h"

namespace haptiv {

/// `haptiv bench`: the program's own measurements.
void addBenchCommand(const Command& program);

}  // namespace haptiv
