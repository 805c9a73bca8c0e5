#include "app/session/recording/SessionSummary.h"

#include <algorithm>

namespace haptiv {

void SessionSummary::take(const TickRecord& record) {
  ++ticks;
  missedTicks = record.missedTicks;
  maxForce = std::max(maxForce, record.environmentForce.norm());
  maxPenetration = std::max(maxPenetration, record.penetration);
  const bool first = ticks == 1;
  const std::int32_t before = first ? 0 : last.contacts;
  contacts += static_cast<std::uint64_t>(std::max(record.contacts - before, 0));
  clamps |= record.clamps;
  last = record;
}

}  // namespace haptiv
