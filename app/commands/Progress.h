#pragma once

#include <cstddef>
#include <string>

namespace haptiv {

/// Tells on stderr how far a long command has come: a bar that moves on a terminal, elsewhere a line a step.
class Progress {
 public:
  /// @param steps  how many there will be
  explicit Progress(std::size_t steps);
  ~Progress() { finish(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// The next step begins.
  void step(const std::string& name);
  /// Wipes the bar away.
  void finish();

 private:
  std::size_t steps_;
  std::size_t step_ = 0;
  bool terminal_;
  bool drawn_ = false;
};

}  // namespace haptiv
