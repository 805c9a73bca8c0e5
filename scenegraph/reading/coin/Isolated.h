#pragma once

#include <functional>
#include <string>

namespace haptiv {

/// How work in a process of its own ended.
struct Isolated {
  std::string result;  ///< what the work returned
  std::string
      fault;  ///< why there is no result: it crashed, took too long or too much memory; empty where there is one
};

/// Runs Coin over something hostile where a crash or a hang costs nothing: in a child process, which is given 60 s, 4
/// GB of memory more than this one has, and no way to open a file. Only its result comes back; whatever else it changes
/// is lost with it. Exceptions become faults. Thread: GUI.
Isolated runIsolated(const std::function<std::string()>& work);

/// Within the work: what is being done, for the fault. Elsewhere: nothing. Cheap.
void tellProgress(const std::string& doing);

/// While it lives, the child may open files.
class FilesAllowed {
 public:
  FilesAllowed();
  ~FilesAllowed();
  FilesAllowed(const FilesAllowed&) = delete;
  FilesAllowed& operator=(const FilesAllowed&) = delete;
};

}  // namespace haptiv
