#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/bench/BenchResult.h"
#include "app/bench/measuring/CallTimes.h"
#include "app/bench/wall/WallMap.h"

namespace haptiv {

/// What can be chosen; of the bench `wall`.
struct BenchSettings {
  DeviceDescription device;
  double rate = 1000;  ///< [Hz]
  WallNet net;
};

/// What benches put their results into, and tell how far they are.
class BenchRun {
 public:
  explicit BenchRun(BenchSettings settings) : settings_(std::move(settings)) {}
  const BenchSettings& settings() const { return settings_; }

  /// One line on stderr, for a person who waits.
  void tell(const std::string& what) const;

  void add(BenchResult result) { results_.push_back(std::move(result)); }
  const std::vector<BenchResult>& results() const { return results_; }

  void keep(WallMap map) { wallMap_ = std::move(map); }
  /// Of the bench `wall`; nothing where it has not run.
  const std::optional<WallMap>& wallMap() const { return wallMap_; }

 private:
  BenchSettings settings_;
  std::optional<WallMap> wallMap_;
  std::vector<BenchResult> results_;
};

/// A result with the figures of `times`.
BenchResult resultOf(std::string name, std::uint64_t n, const CallTimes& times);

}  // namespace haptiv
