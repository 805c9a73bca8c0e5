#include "app/bench/BenchRun.h"

#include <iostream>

namespace haptiv {

void BenchRun::tell(const std::string& what) const {
  std::cerr << "bench: " << what << "\n";
}

BenchResult resultOf(std::string name, std::uint64_t n, const CallTimes& times) {
  BenchResult result;
  result.name = std::move(name);
  result.n = n;
  result.medianNs = times.median();
  result.p99Ns = times.p99();
  return result;
}

}  // namespace haptiv
