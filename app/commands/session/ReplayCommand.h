#pragma once

#include "app/commands/Command.h"

namespace haptiv {

/// `haptiv replay`: does with a session log what the options ask for; opens it in the window where they ask for
/// nothing. kNotSo where --verify finds a difference. argc and argv are the program's own.
void addReplayCommand(const Command& program, int argc, char** argv);

}  // namespace haptiv
