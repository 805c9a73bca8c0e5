#include "app/bench/measuring/CallTimes.h"

#include <algorithm>

namespace haptiv {
namespace {

/// What is measured of a call that does nothing [ns].
double clockOverhead() {
  static const double overhead = [] {
    std::vector<double> times;
    for (int i = 0; i < 10001; ++i) {
      const auto begin = std::chrono::steady_clock::now();
      asm volatile("" : : : "memory");
      times.push_back(static_cast<double>((std::chrono::steady_clock::now() - begin) / std::chrono::nanoseconds(1)));
    }
    return quantile(times, 0.5);
  }();
  return overhead;
}

double medianOf(std::vector<double> values) {
  return values.empty() ? 0 : quantile(values, 0.5);
}

}  // namespace

double quantile(std::vector<double>& values, double part) {
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

CallTimes::CallTimes(std::size_t most) {
  clockOverhead();
  pass_.reserve(most);
}

void CallTimes::endPass() {
  if (pass_.empty()) return;
  calls_ += pass_.size();
  medians_.push_back(std::max(0.0, quantile(pass_, 0.5) - clockOverhead()));
  p99s_.push_back(std::max(0.0, quantile(pass_, 0.99) - clockOverhead()));
  pass_.clear();
}

double CallTimes::median() const {
  return medianOf(medians_);
}

double CallTimes::p99() const {
  return medianOf(p99s_);
}

}  // namespace haptiv
