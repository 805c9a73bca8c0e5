#pragma once

#include "app/commands/Command.h"

namespace haptiv {

/// `haptiv board`: a virtual interface board, served over USB/IP.
void addBoardCommand(const Command& program);

}  // namespace haptiv
