#pragma once

#include <string>

#include "app/commands/Report.h"
#include "app/commands/scene/LoadedScene.h"

namespace haptiv {

/// How the walls of a valid scene feel, one entry for each property node that walls have: line, node, how many walls,
/// stiffness, damping, natural frequency (31), damping ratio (32), optimal stiffness (33), the largest stiffness that
/// can be rendered stably, and how deep the device's peak force presses.
Report::List wallProperties(const LoadedScene& loaded, double rate);

/// The same as a table for people, of at most so many rows; empty where there are no walls.
std::string wallTable(const LoadedScene& loaded, double rate);

}  // namespace haptiv
