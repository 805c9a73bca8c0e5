#pragma once

#include <sys/types.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/app/commands/TestFolder.h"

namespace haptiv {

/// How a run of the program ended.
struct Ended {
  int code = -1;    ///< exit code; 128 + N after signal N, as a shell says it
  std::string out;  ///< stdout
  std::string err;  ///< stderr

  /// All of stdout as one JSON value; discarded (is_discarded) where it is none.
  nlohmann::json json() const { return nlohmann::json::parse(out, nullptr, false); }
};

/// `haptiv ARGS` as a user without a display starts it. Killed when it has not ended after a minute.
class HaptivProgram {
 public:
  /// stdoutPath: where stdout goes instead of `out`; empty: nowhere else.
  explicit HaptivProgram(const std::vector<std::string>& arguments, const std::string& stdoutPath = {});
  ~HaptivProgram();
  HaptivProgram(const HaptivProgram&) = delete;
  HaptivProgram& operator=(const HaptivProgram&) = delete;

  void send(int signal) const;
  /// Waits for the end.
  Ended wait();

 private:
  TestFolder folder_;  // of what it prints
  pid_t process_ = -1;
};

/// Runs `haptiv ARGS` to its end.
Ended runHaptiv(const std::vector<std::string>& arguments);

}  // namespace haptiv
