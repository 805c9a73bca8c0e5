#pragma once

#include <filesystem>

#include "app/session/log/reading/SessionLog.h"

namespace haptiv {

/// Writes every tick of a log as CSV: a header whose names carry their units, `t_s` first, SI units, the shortest
/// decimals that give the same doubles again. Overwrites. Throws std::runtime_error where the file cannot be written.
void exportCsv(const SessionLog& log, const std::filesystem::path& path);

}  // namespace haptiv
