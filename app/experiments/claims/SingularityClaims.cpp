#include <algorithm>
#include <cmath>

#include "app/experiments/claims/Claims.h"
#include "app/experiments/claims/Measure.h"

namespace haptiv {
namespace {

constexpr double kWantedSigma = 0.3;  // smallest rotational singular value that a criterion is to keep

void addByRadius(Claim& claim, const std::string& name, const std::vector<const RunResult*>& runs) {
  for (const RunResult* run : runs)
    claim.values.emplace_back(name + "_r" + fixed(run->setup.varied), leastSigmaRot(*run));
}

Claim singularRadii(const RunTable& table) {
  Claim claim{
      .id = "circle-full-nonopt-singular",
      .text = "Full solution, nonopt: runs into rotational singularities at r = 0.4, 0.6, 0.8 m and not at 0.05, 0.2 m",
      .seenIf = "the least rotational singular value, 0.647 at the start, falls below 0.05 at exactly these radii"};
  const Runs runs = circles(table, full(Strategy::nonopt));
  if (!runs) return claim;
  claim.measured = "least singular value at r [m] " + listText(*runs, leastSigmaRot);
  addByRadius(claim, "sigma_min_rot", *runs);
  claim.judge(std::ranges::all_of(
      *runs, [](const RunResult* run) { return (leastSigmaRot(*run) < kSingular) == (run->setup.varied > 0.3); }));
  return claim;
}

/// Least rotational singular value over all radii, for each criterion.
Claim criteriaPrevent(const RunTable& table, Solution solution) {
  const std::string which = nameOf(solution);
  Claim claim{.id = "circle-" + which + "-criteria-prevent",
              .text = "Every side criterion prevents the rotational singularities, " + which + " solution",
              .seenIf = "the least rotational singular value stays above 0.1 at all radii, for man, dir and cond"};
  bool prevented = true;
  for (const Strategy strategy : kCriteria) {
    const Runs runs = circles(table, {strategy, solution});
    if (!runs) return claim;
    double least = HUGE_VAL;
    for (const RunResult* run : *runs) least = std::min(least, leastSigmaRot(*run));
    claim.measured += (claim.measured.empty() ? "" : ", ") + nameOf(strategy) + " " + text(least);
    claim.values.emplace_back("sigma_min_rot_" + nameOf(strategy), least);
    prevented = prevented && least > kRegular;
  }
  claim.judge(prevented);
  return claim;
}

Claim criterionKeepsSigma(const RunTable& table, const ResolutionChoice& choice) {
  const std::string which = nameOf(choice.solution) + "-" + nameOf(choice.strategy);
  Claim claim{.id = "circle-" + which + "-sigma",
              .text = "The documented step length keeps the least rotational singular value above 0.3 at all radii: " +
                      nameOf(choice.strategy) + ", " + nameOf(choice.solution) + " solution",
              .seenIf = "it is above 0.3 in each tick of the five circles"};
  const Runs runs = circles(table, choice);
  if (!runs) return claim;
  claim.measured = "at r [m] " + listText(*runs, leastSigmaRot);
  addByRadius(claim, "sigma_min_rot", *runs);
  const RunResult* worst =
      *std::ranges::min_element(*runs, {}, [](const RunResult* run) { return leastSigmaRot(*run); });
  claim.judge(leastSigmaRot(*worst) > kWantedSigma);
  if (claim.verdict == Verdict::notSeen) claim.measured += "; " + whySigmaFalls(*worst);
  return claim;
}

}  // namespace

std::vector<Claim> singularityClaims(const RunTable& table) {
  std::vector<Claim> claims = {singularRadii(table), criteriaPrevent(table, Solution::full),
                               criteriaPrevent(table, Solution::partitioned)};
  for (const Solution solution : kSolutions) {
    for (const Strategy strategy : kCriteria) claims.push_back(criterionKeepsSigma(table, {strategy, solution}));
  }
  return claims;
}

}  // namespace haptiv
