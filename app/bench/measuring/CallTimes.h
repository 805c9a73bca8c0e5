#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

namespace haptiv {

/// How long single calls take [ns], the reading of the clock taken off.
///
/// Calls are timed one by one, so that rare slow ones show. The same work is done in several passes: the figures are
/// the medians over the passes of each pass's median and 99th percentile, for a pass may fall into a time in which
/// something else had the machine. Nothing is left out.
class CallTimes {
 public:
  /// @param most  calls in a pass, at most
  explicit CallTimes(std::size_t most);

  /// Calls it and notes the time.
  template <typename Call>
  auto time(Call&& call) {
    const Clock::time_point begin = Clock::now();
    auto result = call();
    asm volatile("" : : "g"(&result) : "memory");  // computed before the clock is read again
    take(Clock::now() - begin);
    return result;
  }
  /// Ends a pass; one without calls does not count.
  void endPass();

  std::size_t calls() const { return calls_; }
  double median() const;
  double p99() const;

 private:
  using Clock = std::chrono::steady_clock;
  void take(Clock::duration time) { pass_.push_back(static_cast<double>(time / std::chrono::nanoseconds(1))); }

  std::vector<double> pass_;
  std::vector<double> medians_, p99s_;  // of the passes
  std::size_t calls_ = 0;
};

/// The value below which a part of others lies, 0 to 1. Sorts them partly; there is at least one.
double quantile(std::vector<double>& values, double part);

}  // namespace haptiv
