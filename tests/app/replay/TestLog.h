#pragma once

#include <QTemporaryDir>
#include <functional>
#include <vector>

#include "app/session/log/reading/SessionLog.h"

namespace haptiv {

inline constexpr int kLongEnough = 60'000;  ///< [ms] until a test gives up waiting; how long it took is not asserted

/// What the test logs hold: a tick each millisecond, and at tick n a position and forces that tell n.
TickRecord testTick(std::uint64_t tick);
/// Ticks 0 to count - 1, without those of which `missed` is true.
std::vector<TickRecord> testTicks(std::uint64_t count, const std::function<bool(std::uint64_t)>& missed = {});

/// Session logs in a folder that goes with it.
class TestLogs {
 public:
  enum class End { orderly, cutOff };

  /// Writes these ticks, with a scene for each version in them, and opens the log.
  SessionLog make(const std::vector<TickRecord>& ticks, End end = End::orderly, std::uint64_t dropped = 0);

 private:
  QTemporaryDir folder_;
  int made_ = 0;
};

}  // namespace haptiv
