#pragma once

#include <optional>
#include <string>

namespace haptiv {

/// Empty paths: not asked for.
struct RunOptions {
  std::string scene;
  std::string device = "sim";
  std::string hand = "rest";
  std::optional<double> seconds;  ///< none: as long as the hand file, and a second more
  double rate = 1000;             ///< [Hz]
  std::string strategy = "nonopt";
  std::string log;
  std::string picture;
  bool solid = false;
  bool fast = false;
  bool json = false;
};

/// `haptiv run`: a session without a window. kNotSo where the scene has errors or a fault stopped the arm.
int runSession(const RunOptions& options);

}  // namespace haptiv
