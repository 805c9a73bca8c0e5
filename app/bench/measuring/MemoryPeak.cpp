#include "app/bench/measuring/MemoryPeak.h"

#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace haptiv {
namespace {

/// A line of /proc/self/status, kB -> MiB.
std::optional<double> statusOf(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kibibytes = 0;
    if (word == key && status >> kibibytes) return kibibytes / 1024;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> memoryHeld() {
  malloc_trim(0);
  return statusOf("VmRSS:");
}

MemoryPeak::MemoryPeak() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";  // the peak begins anew
  before_ = statusOf("VmRSS:");
}

std::optional<double> MemoryPeak::grownBy() const {
  const std::optional<double> peak = statusOf("VmHWM:");
  if (!before_ || !peak) return std::nullopt;
  return std::max(0.0, *peak - *before_);
}

}  // namespace haptiv
