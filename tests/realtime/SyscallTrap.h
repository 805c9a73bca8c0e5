#pragma once

#include <cstddef>
#include <string>

namespace haptiv::testing {

/// From here on, this thread's system calls fail (ENOSYS) and are counted: all but those of the sleep and of the clock
/// where the kernel has it no cheaper (clock_nanosleep, clock_gettime), and the thread's own end. Cannot be undone: for
/// a thread that ends.
/// @return  empty, or why it cannot be done here
std::string trapSyscalls();

/// How many were caught so far, of all threads with a trap, and the number of the last one.
std::size_t caughtSyscalls() noexcept;
int lastCaughtSyscall() noexcept;

}  // namespace haptiv::testing
