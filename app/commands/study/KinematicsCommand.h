#pragma once

#include "app/commands/Command.h"

namespace haptiv {

/// `haptiv kinematics`: pose, Jacobian and dexterity of an arm at these joint angles.
void addKinematicsCommand(const Command& program);

}  // namespace haptiv
