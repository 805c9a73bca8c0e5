#pragma once

#include <optional>

namespace haptiv {

/// How much more memory this process comes to hold at most, from the making of this on; what was freed before is given
/// back to the system first.
class MemoryPeak {
 public:
  MemoryPeak();
  /// [MiB]; nothing where the system does not tell.
  std::optional<double> grownBy() const;

 private:
  std::optional<double> before_;
};

/// What this process holds now; what has been freed is given back to the system first. [MiB]; nothing where the system
/// does not tell.
std::optional<double> memoryHeld();

}  // namespace haptiv
