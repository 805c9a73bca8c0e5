#pragma once

#include <string>
#include <vector>

namespace haptiv {

struct ReplayOptions {
  std::string log;
  bool verify = false;
  std::vector<std::string> changes;  ///< NODE.FIELD=VALUE
  std::string exported;              ///< CSV to be written; empty: none
  bool json = false;
};

/// `haptiv replay`: does with a session log what the options ask for; opens it in the window where they ask for
/// nothing. kNotSo where --verify finds a difference. argc and argv are the program's own.
int replayLog(int argc, char** argv, const ReplayOptions& options);

}  // namespace haptiv
