#include "haptics/realtime/RealtimeThread.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstring>

namespace haptiv {
namespace {

constexpr int kPriority = 80;  // above most of the system, below the kernel's own watchdogs

/// Zero, or the error number.
int askForFifo(std::thread& thread) {
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  return pthread_setschedparam(thread.native_handle(), SCHED_FIFO, &parameters);
}

/// Pages stay once they are touched; nothing is touched for it. Under a limit, later allocations of the whole program
/// would fail at the limit, so the memory is left alone; root has no limit.
bool lockMemory() {
  rlimit limit{};
  const bool unlimited = getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY;
  if (!unlimited && geteuid() != 0) return false;
  return mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
}

}  // namespace

Scheduling makeRealtime(std::thread& thread) {
  Scheduling scheduling;
  const int error = askForFifo(thread);
  scheduling.realtime = error == 0;
  scheduling.memoryLocked = lockMemory();
  if (scheduling.realtime) {
    scheduling.explanation = "The servo runs under real-time scheduling (SCHED_FIFO, priority 80)";
    scheduling.explanation += scheduling.memoryLocked
                                  ? ", its memory locked."
                                  : "; its memory is not locked: allow it with 'memlock unlimited' in "
                                    "/etc/security/limits.d for less rare delays.";
    return scheduling;
  }
  scheduling.explanation = std::string(
                               "The servo runs under ordinary scheduling, with delays of milliseconds under "
                               "load (SCHED_FIFO: ") +
                           std::strerror(error) +
                           "): allow real time with 'rtprio 90' and 'memlock unlimited' for your user in "
                           "/etc/security/limits.d, then log in again.";
  return scheduling;
}

}  // namespace haptiv
