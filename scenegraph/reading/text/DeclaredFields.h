#pragma once

#include <set>
#include <string>
#include <vector>

namespace haptiv {

/// Why `fields [ TYPE NAME, ... ]` of a node may not be read; empty where it may.
///
/// Coin crashes where a node that it knows declares a field that it has not: a newer file in an older program.
/// @param declared  TYPE, NAME, TYPE, NAME, ...
std::string declaredFieldsFault(const std::string& keyword, bool vrml2, const std::vector<std::string>& declared);

/// Whether nodes of this keyword have a field of one of these names.
bool hasFieldOf(const std::string& keyword, bool vrml2, const std::set<std::string>& names);

}  // namespace haptiv
