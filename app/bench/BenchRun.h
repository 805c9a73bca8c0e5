#pragma once

#include <string>
#include <vector>

#include "app/bench/BenchResult.h"
#include "app/bench/CallTimes.h"

namespace haptiv {

/// What benches put their results into, and tell how far they are.
class BenchRun {
 public:
  /// One line on stderr, for a person who waits.
  void tell(const std::string& what) const;

  void add(BenchResult result) { results_.push_back(std::move(result)); }
  const std::vector<BenchResult>& results() const { return results_; }

 private:
  std::vector<BenchResult> results_;
};

/// A result with the figures of `times`.
BenchResult resultOf(std::string name, std::uint64_t n, const CallTimes& times);

}  // namespace haptiv
