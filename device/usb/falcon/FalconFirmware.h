#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace haptiv::falcon {

inline constexpr std::size_t kFirmwareBlock = 128;  ///< bytes that are sent, and come back, at a time

/// The firmware file that the user supplies: the maker's, for its licence lets nobody pass it on.
/// Throws std::runtime_error where it is not there, cannot be read, or cannot be a firmware by its size or by being
/// text: what, and what to do. What its bytes do, nobody can tell: it is the user's.
std::vector<std::uint8_t> readFirmware(const std::string& path);

/// Keeps a copy of such a file where it is looked for from now on, by window and command line, unless
/// $HAPTIV_FALCON_FIRMWARE names another, and returns its path. Throws as readFirmware does, and where it cannot be
/// written; a file that was kept before stays then.
std::string keepFirmware(const std::string& path);

/// Where the file is looked for if the user names none: $HAPTIV_FALCON_FIRMWARE, or else haptiv/falcon.bin in
/// $XDG_DATA_HOME (~/.local/share).
std::string firmwarePath();

}  // namespace haptiv::falcon
