#pragma once

#include <cstdint>
#include <optional>

namespace haptiv {

/// What Linux has counted of one thread.
struct ThreadCounters {
  std::uint64_t pageFaults = 0;     ///< that the thread itself ran into
  std::uint64_t interruptions = 0;  ///< times that it was stopped while it had something to do
};

/// The one thread of this process that runs under SCHED_FIFO; nothing where there is none, or another one.
std::optional<int> realtimeThread();

/// Nothing where the thread is no more.
std::optional<ThreadCounters> countersOf(int thread);

}  // namespace haptiv
