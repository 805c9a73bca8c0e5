#pragma once

#include <cstddef>

namespace haptiv::testing {

/// What a thread asked for that can make it wait, however deep in a library.
struct HiddenCalls {
  std::size_t heap = 0;   ///< malloc, free and their kin, new and Eigen's heap included
  std::size_t locks = 0;  ///< mutexes, rwlocks, condition variables and semaphores, free ones included

  HiddenCalls operator-(const HiddenCalls& before) const noexcept { return {heap - before.heap, locks - before.locks}; }
};

/// Of this thread, since it began.
HiddenCalls hiddenCalls() noexcept;

/// What `work` makes of them on this thread.
template <typename Work>
HiddenCalls hiddenCallsOf(Work&& work) {
  const HiddenCalls before = hiddenCalls();
  work();
  return hiddenCalls() - before;
}

}  // namespace haptiv::testing
