#pragma once

#include <optional>
#include <vector>

#include "app/experiments/RunResult.h"

namespace haptiv {

/// The average best value of the indices, by which they are divided where runs are compared  [paper, section VI].
struct IndexScale {
  double trans = 1;  ///< [m^3]
  double rot = 1;
};

/// The strategies that optimise.
inline constexpr Strategy kCriteria[] = {Strategy::man, Strategy::dir, Strategy::cond};

/// All runs that were made, found by what they are.
class RunTable {
 public:
  RunTable(std::vector<RunResult> runs, const IndexScale& scale) : runs_(std::move(runs)), scale_(scale) {}

  const std::vector<RunResult>& runs() const { return runs_; }
  const IndexScale& scale() const { return scale_; }

  /// Null where there is no such run.
  const RunResult* find(Experiment experiment, const ResolutionChoice& choice, double varied) const;
  /// The runs at all of these values, in their order; nothing where one is missing.
  template <std::size_t Count>
  std::optional<std::vector<const RunResult*>> all(Experiment experiment, const ResolutionChoice& choice,
                                                   const double (&varied)[Count]) const {
    std::vector<const RunResult*> found;
    for (const double value : varied) {
      const RunResult* run = find(experiment, choice, value);
      if (!run) return std::nullopt;
      found.push_back(run);
    }
    return found;
  }

 private:
  std::vector<RunResult> runs_;
  IndexScale scale_;
};

}  // namespace haptiv
