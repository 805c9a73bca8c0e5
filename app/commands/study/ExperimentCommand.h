#pragma once

#include "app/commands/Command.h"

namespace haptiv {

/// `haptiv experiment`: the paper's numerical experiments; a CSV each, figures, and a verdict on each claim.
void addExperimentCommand(const Command& program);

}  // namespace haptiv
