#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "app/session/log/hdf5/Hdf5.h"
#include "app/session/log/reading/SessionLog.h"

namespace haptiv {

/// As far as a hostile file may make us allocate for one text; a real log stays far below. [bytes]
inline constexpr std::uint64_t kLongestText = 256u << 20;
inline constexpr const char* kDamaged = "The file is damaged: use another copy of it";

/// The scenes of a log, in their order. Throws as SessionLog's constructor does.
/// @param complete  the log was ended: otherwise the last scene may have been cut off, and is left out
std::vector<LoggedScene> readLoggedScenes(const hdf5::Handle& file, const std::filesystem::path& path, bool complete);

}  // namespace haptiv
