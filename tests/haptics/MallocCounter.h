#pragma once

#include <cstddef>

namespace haptiv::testing {

/// How often this thread has asked for memory so far, by malloc and its kin or by new; Eigen's heap included.
/// Always zero under a sanitizer, which has an allocator of its own.
std::size_t allocationsOfThisThread() noexcept;

/// Whether the counter counts in this build.
bool countsAllocations() noexcept;

}  // namespace haptiv::testing
