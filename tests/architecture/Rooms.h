#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/architecture/Sources.h"

namespace haptiv::testing {

/// What a folder holds: the folders in it, each with all that is below it, and its own files, which are one more room.
/// Which of these include which, and the lines by which they do.
using RoomsOfFolder = std::map<std::string, std::map<std::string, std::vector<Found>>>;

/// All folders that hold sources, by their path from the project's root; "" is the root itself.
/// @param includes  of the whole tree; what they include of other projects is passed over
std::map<std::string, RoomsOfFolder> foldersOf(const std::vector<Found>& includes);

/// The rooms that include themselves by way of others.
std::set<std::string> circleOf(const RoomsOfFolder& rooms);

}  // namespace haptiv::testing
