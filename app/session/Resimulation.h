#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/session/SessionLog.h"

namespace haptiv {

/// Where a re-simulated session first differs from the logged one.
struct Difference {
  std::uint64_t tick = 0;
  std::string field;      ///< such as "desired_position_x_m"
  double logged = 0;
  double resimulated = 0;
};

struct Verification {
  std::uint64_t ticks = 0;  ///< compared
  std::optional<Difference> first;
  bool identical() const { return !first.has_value(); }
};

/// Runs the logged inputs through the same tick again and compares every result bit for bit.
Verification verify(const SessionLog& log);

}  // namespace haptiv
