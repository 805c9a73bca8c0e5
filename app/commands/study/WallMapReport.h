#pragma once

#include <string>

#include "app/bench/wall/WallMap.h"
#include "app/commands/Report.h"

namespace haptiv {

/// The map with units in its names; in lists of stiffness null means that all were stable, in the rows of shaking that
/// the contact was lost or a fault stood.
Report reportOf(const WallMap& map);

/// wall.png, wall-limits.csv and wall-shaking.csv. Throws CommandFailure where one of them cannot be written.
void writeWallFiles(const WallMap& map, const std::string& folder);

}  // namespace haptiv
