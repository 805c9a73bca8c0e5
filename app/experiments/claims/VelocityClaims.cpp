#include <algorithm>
#include <cmath>

#include "app/experiments/claims/Claims.h"
#include "app/experiments/claims/Measure.h"

namespace haptiv {
namespace {

constexpr double kSameIndex = 0.02;  // of the greatest index; what the tick's length leaves between two speeds
constexpr double kSlow = kSpeeds[0], kFast = kSpeeds[1];

const RunResult* at(const RunTable& table, const ResolutionChoice& choice, double speed) {
  return table.find(Experiment::velocities, choice, speed);
}

/// The index at this angle along the path, straight between samples.
double transAt(const RunResult& run, double phi) {
  const double place = phi / run.setup.path.angle(run.samples[1].time);
  const auto before = std::min(static_cast<std::size_t>(place), run.samples.size() - 2);
  const double part = std::min(place - static_cast<double>(before), 1.);
  return (1 - part) * run.samples[before].indexTrans + part * run.samples[before + 1].indexTrans;
}

Claim nonoptIndependent(const RunTable& table, Solution solution) {
  Claim claim{
      .id = "velocities-" + nameOf(solution) + "-nonopt-same",
      .text = "The results of nonopt do not depend on the velocity, " + nameOf(solution) + " solution",
      .seenIf = "at the same place of the path the translational indices differ by less than 2 % of the greatest"};
  const RunResult* slow = at(table, {Strategy::nonopt, solution}, kSlow);
  const RunResult* fast = at(table, {Strategy::nonopt, solution}, kFast);
  if (!slow || !fast) return claim;
  double most = 0, greatest = 0;
  for (const RunSample& sample : fast->samples) {
    greatest = std::max(greatest, sample.indexTrans);
    most = std::max(most, std::abs(sample.indexTrans - transAt(*slow, fast->setup.path.angle(sample.time))));
  }
  claim.measured = "greatest difference " + text(100 * most / greatest, 2) + " %";
  claim.values = {{"relative_difference", most / greatest}};
  claim.judge(most < kSameIndex * greatest);
  return claim;
}

Claim slowerGainsMore(const RunTable& table, Solution solution) {
  Claim claim{
      .id = "velocities-" + nameOf(solution) + "-slower-gains-more",
      .text = "The benefit of the optimisation grows when the velocity is decreased, " + nameOf(solution) + " solution",
      .seenIf = "with dir, the mean translational index is greater at 0.1 m/s than at 1 m/s"};
  const RunResult* without = at(table, {Strategy::nonopt, solution}, kFast);
  const RunResult* slow = at(table, {Strategy::dir, solution}, kSlow);
  const RunResult* fast = at(table, {Strategy::dir, solution}, kFast);
  if (!without || !slow || !fast) return claim;
  claim.measured = "over nonopt: translational " + gainText(meanTrans(*fast), meanTrans(*without)) + " at 1 m/s, " +
                   gainText(meanTrans(*slow), meanTrans(*without)) + " at 0.1 m/s; rotational " +
                   gainText(meanRot(*fast), meanRot(*without)) + " and " + gainText(meanRot(*slow), meanRot(*without));
  claim.values = {{"trans_gain_slow", meanTrans(*slow) / meanTrans(*without) - 1},
                  {"trans_gain_fast", meanTrans(*fast) / meanTrans(*without) - 1},
                  {"rot_gain_slow", meanRot(*slow) / meanRot(*without) - 1},
                  {"rot_gain_fast", meanRot(*fast) / meanRot(*without) - 1}};
  claim.judge(meanTrans(*slow) > meanTrans(*fast));
  return claim;
}

Claim notAlwaysSuperior(const RunTable& table, Solution solution) {
  Claim claim{
      .id = "velocities-" + nameOf(solution) + "-not-always-superior",
      .text = "At 1 m/s the optimised solution, a local technique, is not superior everywhere, " + nameOf(solution) +
              " solution",
      .seenIf = "with dir, somewhere along the path the translational index is below nonopt's by more than 1 %"};
  const RunResult* without = at(table, {Strategy::nonopt, solution}, kFast);
  const RunResult* with = at(table, {Strategy::dir, solution}, kFast);
  if (!without || !with) return claim;
  const std::size_t count = std::min(with->samples.size(), without->samples.size());
  std::size_t below = 0;
  for (std::size_t i = 0; i < count; ++i) below += with->samples[i].indexTrans < 0.99 * without->samples[i].indexTrans;
  const double share = static_cast<double>(below) / static_cast<double>(count);
  claim.measured = "below nonopt on " + text(100 * share, 2) + " % of the path";
  claim.values = {{"share_below", share}};
  claim.judge(below > 0);
  return claim;
}

Claim fullIsBetter(const RunTable& table) {
  Claim claim{
      .id = "velocities-full-better",
      .text = "Solving for all ten joints at once has significant potential over the partitioned solution",
      .seenIf = "with dir, the mean translational index of the full solution is greater by a quarter at both speeds"};
  bool seen = true;
  for (const double speed : kSpeeds) {
    const RunResult* whole = at(table, full(Strategy::dir), speed);
    const RunResult* parts = at(table, partitioned(Strategy::dir), speed);
    if (!whole || !parts) return claim;
    const double ratio = meanTrans(*whole) / meanTrans(*parts);
    claim.measured += (claim.measured.empty() ? "" : ", ") + text(ratio) + " times at " + text(speed) + " m/s";
    claim.values.emplace_back("ratio_v" + fixed(speed), ratio);
    seen = seen && ratio > 1.25;
  }
  claim.judge(seen);
  return claim;
}

}  // namespace

std::vector<Claim> velocityClaims(const RunTable& table) {
  std::vector<Claim> claims;
  for (const Solution solution : {Solution::full, Solution::partitioned}) {
    claims.push_back(nonoptIndependent(table, solution));
    claims.push_back(slowerGainsMore(table, solution));
    claims.push_back(notAlwaysSuperior(table, solution));
  }
  claims.push_back(fullIsBetter(table));
  claims.push_back(optimisedStaysRegular(table, Experiment::velocities));
  return claims;
}

}  // namespace haptiv
