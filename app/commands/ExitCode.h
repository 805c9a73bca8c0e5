#pragma once

#include <stdexcept>
#include <string>

namespace haptiv {

/// The program's exit codes; scripts rely on them.
enum ExitCode { kGood = 0, kNotSo = 1, kWrongUsage = 2, kCouldNot = 3 };

/// Ends a command: its exit code, and for stderr what happened, where, and what to do.
class CommandFailure : public std::runtime_error {
 public:
  CommandFailure(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const noexcept { return code_; }

 private:
  ExitCode code_;
};

}  // namespace haptiv
