#pragma once

#include <string>
#include <thread>

namespace haptiv {

/// How the servo thread runs, to be told to the user.
struct Scheduling {
  bool realtime = false;  ///< SCHED_FIFO was permitted
  bool memoryLocked = false;
  bool processorAwake = false;  ///< /dev/cpu_dma_latency was permitted
  std::string explanation;      ///< one sentence: what runs, and what to do for better
};

/// Asks for SCHED_FIFO for a running thread, and for the process's memory to stay in RAM.
///
/// Neither is needed: where one is not permitted, the explanation says what to do. The memory stays locked for the
/// life of the process, as another arm's servo may rely on it; it is only locked where the limit is high enough for
/// the rest of the program never to run into it.
Scheduling makeRealtime(std::thread& thread);

}  // namespace haptiv
