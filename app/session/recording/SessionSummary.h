#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "haptics/tick/TickRecord.h"

namespace haptiv {

/// What a session came to; kept tick by tick.
struct SessionSummary {
  std::uint64_t ticks = 0;  ///< run, lost records included
  std::uint64_t missedTicks = 0;
  std::uint64_t droppedRecords = 0;
  double maxForce = 0;         ///< of the environment on the ball [N]
  double maxPenetration = 0;   ///< [m]
  std::uint64_t contacts = 0;  ///< times the ball came to touch a wall
  std::uint32_t clamps = 0;    ///< Clamp bits that held something back at any time
  TickRecord last;
  std::vector<std::filesystem::path> flights;  ///< files with what led to a fault, one a fault

  /// The next tick of the session.
  void take(const TickRecord& record);
};

}  // namespace haptiv
