#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "device/types.h"

namespace haptiv {

/// A load that is hung on the handle, and, where it has been measured already, what the sensor said.
struct KnownLoad {
  Vector6 load = Vector6::Zero();  ///< force and torque, in T [N], [N m]
  std::optional<Vector6> counts;   ///< of the sensor, as means
};

/// Reads a CSV with the header fx,fy,fz,tx,ty,tz, a line a load; c1,..,c6, the sensor's counts under it, may follow.
/// Throws std::runtime_error "FILE:LINE: what, and what to do" for other columns, cells without a finite number, more
/// than 1000 loads and none.
std::vector<KnownLoad> readLoadsFile(const std::filesystem::path& path);

/// The text of such a file, without counts.
std::string loadsText(const std::vector<Vector6>& loads);

}  // namespace haptiv
