#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/experiments/RunTable.h"
#include "app/experiments/claims/Claim.h"
#include "device/control/ResolutionNames.h"

/// What the files of claims share.
namespace haptiv {

/// Rotational singular values, 0.647 at the start of all runs: below the first the arm has run into a singular pose, as
/// closely as 1 ms at 1 m/s lets it; above the second it keeps clear of all.
inline constexpr double kSingular = 0.05;
inline constexpr double kRegular = 0.1;

constexpr ResolutionChoice full(Strategy strategy) {
  return {strategy, Solution::full};
}
constexpr ResolutionChoice partitioned(Strategy strategy) {
  return {strategy, Solution::partitioned};
}

/// Runs of an experiment that differ in nothing but the value it varies; nothing where one of them is missing.
using Runs = std::optional<std::vector<const RunResult*>>;
Runs circles(const RunTable& table, const ResolutionChoice& choice);

/// Three significant digits, or as many as `digits`.
std::string text(double number, int digits = 3);
/// Two decimals, as in the names of files.
std::string fixed(double number);
/// "+12 %", of one over the other.
std::string gainText(double with, double without);

/// "0.05: 1.2, 0.2: 3.4": by the runs' varied values, what `of` tells of each.
template <typename Of>
std::string listText(const std::vector<const RunResult*>& runs, Of of) {
  std::string list;
  for (const RunResult* run : runs)
    list += (list.empty() ? "" : ", ") + text(run->setup.varied, 2) + ": " + text(of(*run));
  return list;
}

double leastSigmaRot(const RunResult& run);
double meanTrans(const RunResult& run);
double meanRot(const RunResult& run);

/// Where and when a run's least rotational singular value came about, and whether the start had it already.
std::string whySigmaFalls(const RunResult& run);

/// The optimised full solution keeps the rotational stage regular in all runs of the experiment.
Claim optimisedStaysRegular(const RunTable& table, Experiment experiment);

}  // namespace haptiv
