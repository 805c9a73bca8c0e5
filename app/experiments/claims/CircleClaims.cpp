#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/experiments/claims/Claims.h"
#include "app/experiments/claims/Measure.h"

namespace haptiv {
namespace {

constexpr double kConstant = 1e-9;      // relative; what rounding and the drift correction leave
constexpr double kSmallGain = 0.25;     // of the translational index, over that of the rotational one
constexpr double kSimilar = 0.5;        // distance of two criteria, over that of one from nonopt
constexpr double kAlmostTheSame = 0.1;  // relative spread of means

using Of = double (*)(const RunResult&);

Claim partitionedNonoptConstant(const RunTable& table) {
  Claim claim{.id = "circle-partitioned-nonopt-constant",
              .text = "Partitioned solution, nonopt: the rotational index is constant",
              .seenIf = "its relative spread is below 1e-9 at all radii"};
  const Runs runs = circles(table, partitioned(Strategy::nonopt));
  if (!runs) return claim;
  double spread = 0;
  for (const RunResult* run : *runs)
    spread = std::max(spread, (run->summary.greatestIndexRot - run->summary.leastIndexRot) / run->summary.meanIndexRot);
  claim.measured = "relative spread at most " + text(spread, 2);
  claim.values.emplace_back("relative_spread", spread);
  claim.judge(spread < kConstant);
  return claim;
}

/// What a mean index gains over another set of runs, at each radius; 0.1 is 10 %.
std::vector<double> gains(const std::vector<const RunResult*>& runs, const std::vector<const RunResult*>& over, Of of) {
  std::vector<double> gain;
  for (std::size_t i = 0; i < runs.size(); ++i) gain.push_back(of(*runs[i]) / of(*over[i]) - 1);
  return gain;
}

double mean(const std::vector<double>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.) / static_cast<double>(numbers.size());
}

/// "rotational +40 % to +110 %"
void addGain(Claim& claim, const std::string& strategy, const std::string& index, const std::vector<double>& gain) {
  const auto [low, high] = std::ranges::minmax(gain);
  claim.measured += index + " " + gainText(1 + low, 1) + " to " + gainText(1 + high, 1);
  claim.values.emplace_back(strategy + "_" + index + "_gain_min", low);
  claim.values.emplace_back(strategy + "_" + index + "_gain_max", high);
}

struct Gains {
  std::vector<double> rot, trans;
};

/// Of one criterion's runs over others, told in the claim.
Gains tellGains(Claim& claim, Strategy strategy, const std::vector<const RunResult*>& runs,
                const std::vector<const RunResult*>& over) {
  const Gains gain{gains(runs, over, meanRot), gains(runs, over, meanTrans)};
  claim.measured += (claim.measured.empty() ? "" : "; ") + nameOf(strategy) + ": ";
  addGain(claim, nameOf(strategy), "rotational", gain.rot);
  claim.measured += ", ";
  addGain(claim, nameOf(strategy), "translational", gain.trans);
  return gain;
}

Claim fullImproves(const RunTable& table) {
  Claim claim{.id = "circle-full-improves-both",
              .text = "Full solution: for all trajectories the rotational and the translational index can be improved",
              .seenIf = "at each radius some criterion has greater means of both than nonopt"};
  const Runs without = circles(table, full(Strategy::nonopt));
  if (!without) return claim;
  std::vector<bool> improved(without->size(), false);
  for (const Strategy strategy : kCriteria) {
    const Runs runs = circles(table, full(strategy));
    if (!runs) return claim;
    const Gains gain = tellGains(claim, strategy, *runs, *without);
    for (std::size_t i = 0; i < improved.size(); ++i)
      improved[i] = improved[i] || (gain.rot[i] > 0 && gain.trans[i] > 0);
  }
  claim.judge(std::ranges::count(improved, false) == 0);
  return claim;
}

Claim partitionedGains(const RunTable& table) {
  Claim claim{.id = "circle-partitioned-gains",
              .text = "Partitioned solution: the rotational index improves, translational gains are small",
              .seenIf =
                  "for each criterion the mean rotational index grows at all radii, and the translational one, on "
                  "average over the radii, by less than a quarter of that"};
  const Runs without = circles(table, partitioned(Strategy::nonopt));
  if (!without) return claim;
  bool seen = true;
  for (const Strategy strategy : kCriteria) {
    const Runs runs = circles(table, partitioned(strategy));
    if (!runs) return claim;
    const Gains gain = tellGains(claim, strategy, *runs, *without);
    seen = seen && std::ranges::min(gain.rot) > 0 && mean(gain.trans) < kSmallGain * mean(gain.rot);
  }
  claim.judge(seen);
  return claim;
}

Claim adversarialPose(const RunTable& table) {
  Claim claim{
      .id = "circle-partitioned-adversarial",
      .text =
          "Partitioned solution, r = 0.8 m: nonopt drives the SCARA segment into an adversarial configuration "
          "at t = 3.6 s, the optimisation prevents it",
      .seenIf = "nonopt's translational index is least between 3.5 and 3.7 s, and each criterion's is greater then"};
  const RunResult* without = table.find(Experiment::circle, partitioned(Strategy::nonopt), 0.8);
  if (!without) return claim;
  const auto worst = std::ranges::min_element(without->samples, {}, &RunSample::indexTrans);
  const auto place = worst - without->samples.begin();
  claim.measured =
      "nonopt least, " + text(worst->indexTrans / table.scale().trans) + ", at " + text(worst->time) + " s; then";
  claim.values = {{"nonopt_worst_time_s", worst->time}};
  bool prevented = true;
  for (const Strategy strategy : kCriteria) {
    const RunResult* run = table.find(Experiment::circle, partitioned(strategy), 0.8);
    if (!run) return claim;
    const double gain = run->samples[static_cast<std::size_t>(place)].indexTrans / worst->indexTrans;
    claim.measured += " " + nameOf(strategy) + " " + gainText(gain, 1);
    claim.values.emplace_back(nameOf(strategy) + "_gain", gain - 1);
    prevented = prevented && gain > 1;
  }
  claim.judge(prevented && worst->time > 3.5 && worst->time < 3.7);
  return claim;
}

/// The mean, over the radii, of how far the means of two sets of runs are apart.
double distance(const std::vector<const RunResult*>& a, const std::vector<const RunResult*>& b, Of of) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(of(*a[i]) - of(*b[i]));
  return sum / static_cast<double>(a.size());
}

Claim dirAndCondSimilar(const RunTable& table, Solution solution) {
  Claim claim{.id = "circle-" + nameOf(solution) + "-dir-cond-similar",
              .text = "dir and cond give similar results, " + nameOf(solution) + " solution",
              .seenIf =
                  "their mean indices, rotational and translational, are on average over the radii less than half "
                  "as far from each other as dir's are from nonopt's"};
  const Runs dir = circles(table, {Strategy::dir, solution}), cond = circles(table, {Strategy::cond, solution});
  const Runs without = circles(table, {Strategy::nonopt, solution});
  if (!dir || !cond || !without) return claim;
  const double rot = distance(*dir, *cond, meanRot) / distance(*dir, *without, meanRot);
  const double trans = distance(*dir, *cond, meanTrans) / distance(*dir, *without, meanTrans);
  claim.measured = "from each other " + text(100 * rot, 2) + " % (rotational) and " + text(100 * trans, 2) +
                   " % (translational) of dir's distance from nonopt";
  claim.values = {{"rotational_distance_ratio", rot}, {"translational_distance_ratio", trans}};
  claim.judge(rot < kSimilar && trans < kSimilar);
  return claim;
}

Claim nearBase(const RunTable& table, Solution solution) {
  Claim claim{.id = "circle-" + nameOf(solution) + "-near-base",
              .text = "The mean translational index is almost the same at r = 0.05, 0.2 and 0.4 m, optimised, " +
                      nameOf(solution) + " solution",
              .seenIf = "it falls from the best to the worst of these radii by less than 10 %, for man, dir and cond"};
  bool seen = true;
  for (const Strategy strategy : kCriteria) {
    const Runs runs = table.all(Experiment::circle, {strategy, solution}, {0.05, 0.2, 0.4});
    if (!runs) return claim;
    const auto [low, high] = std::ranges::minmax(*runs, {}, [](const RunResult* run) { return meanTrans(*run); });
    const double fall = 1 - meanTrans(*low) / meanTrans(*high);
    claim.measured += (claim.measured.empty() ? "" : "; ") + nameOf(strategy) + " falls by " + text(100 * fall, 2) +
                      " % (" +
                      listText(*runs, [&](const RunResult& run) { return meanTrans(run) / table.scale().trans; }) + ")";
    claim.values.emplace_back(nameOf(strategy) + "_fall", fall);
    seen = seen && fall < kAlmostTheSame;
  }
  claim.judge(seen);
  return claim;
}

Claim partitionedInferior(const RunTable& table) {
  Claim claim{.id = "circle-partitioned-inferior",
              .text = "The decoupled motion of the partitioned solution is inferior to the full one, in these runs",
              .seenIf = "with dir, both mean indices of the full solution are greater at all radii"};
  const Runs whole = circles(table, full(Strategy::dir)), parts = circles(table, partitioned(Strategy::dir));
  if (!whole || !parts) return claim;
  const Gains gain = tellGains(claim, Strategy::dir, *whole, *parts);
  claim.judge(std::ranges::min(gain.rot) > 0 && std::ranges::min(gain.trans) > 0);
  return claim;
}

}  // namespace

std::vector<Claim> circleClaims(const RunTable& table) {
  std::vector<Claim> claims = {partitionedNonoptConstant(table), partitionedGains(table), adversarialPose(table),
                               fullImproves(table)};
  for (const Solution solution : kSolutions) claims.push_back(dirAndCondSimilar(table, solution));
  for (const Solution solution : kSolutions) claims.push_back(nearBase(table, solution));
  claims.push_back(partitionedInferior(table));
  return claims;
}

}  // namespace haptiv
