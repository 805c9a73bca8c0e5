#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace haptiv {

/// Whether a node's field names files that Coin would open.
bool namesFiles(std::string_view keyword, std::string_view field);

/// Why a scene may not name this file; empty where it may: a regular file in the scene's own folder or below it.
/// One that does not exist is allowed: Coin says so itself.
std::string pathFault(std::string_view path, const std::filesystem::path& folder);

}  // namespace haptiv
