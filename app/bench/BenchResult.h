#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace haptiv {

/// What was measured of one thing: nanoseconds a call.
struct BenchResult {
  std::string name;                                   ///< "collision/contact"
  std::uint64_t n = 0;                                ///< how large the thing is: walls, triangles, records
  double medianNs = 0;                                ///< [ns]
  double p99Ns = 0;                                   ///< [ns]; 99 of 100 calls take less
  std::string peer;                                   ///< what does the same work in the same run; empty: there is none
  std::optional<double> peerMedianNs;                 ///< [ns]
  std::vector<std::pair<std::string, double>> notes;  ///< what else was counted: name with its unit, value
};

}  // namespace haptiv
