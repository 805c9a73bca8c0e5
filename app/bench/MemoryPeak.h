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

}  // namespace haptiv
