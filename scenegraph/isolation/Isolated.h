#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

namespace haptiv {

/// How work in a process of its own ended.
struct Isolated {
  std::string result;  ///< what the work returned
  std::string fault;   ///< why there is no result: a crash, too much time or memory; empty where there is one
  int line = 0;        ///< of the text, at which the work was then; 0: not known
};

/// Runs Coin over something hostile where a crash or a hang costs nothing: in a child process, which is given this
/// time of a processor (and twice as much on the clock), 4 GB of memory more than this one has, and no way to open a
/// file. Only its result comes back; whatever else it changes is lost with it. Exceptions become faults. Thread: GUI.
Isolated runIsolated(const std::function<std::string()>& work, std::chrono::seconds time = std::chrono::seconds(30));

/// Within the work: what is being done, for the fault. Elsewhere: nothing. Cheap.
void tellProgress(std::string_view doing, int line = 0);

/// Within the work: what follows may take this time of a processor, in place of what is left of the time for the whole,
/// which is kept by the clock alone then. Elsewhere: nothing.
void allowTime(std::chrono::seconds time);

/// While it lives, the child may open files.
class FilesAllowed {
 public:
  FilesAllowed();
  ~FilesAllowed();
  FilesAllowed(const FilesAllowed&) = delete;
  FilesAllowed& operator=(const FilesAllowed&) = delete;
};

}  // namespace haptiv
