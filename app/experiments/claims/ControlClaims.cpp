#include <algorithm>
#include <cmath>

#include "app/experiments/Simulation.h"
#include "app/experiments/claims/Claims.h"
#include "app/experiments/claims/Measure.h"

namespace haptiv {
namespace {

constexpr double kNearLimit = 0.9;          // of a joint's rate limit
constexpr double kTrackingWanted = 1e-4;    // [m]
constexpr double kSelfMotionWanted = 1e-9;  // [m] in a tick
constexpr double kRounding = 1e-9;          // of rates [rad/s]

using RunList = std::vector<const RunResult*>;

template <typename Which>
RunList select(const RunTable& table, Which which) {
  RunList runs;
  for (const RunResult& run : table.runs()) {
    if (which(run)) runs.push_back(&run);
  }
  return runs;
}

RunList optimised(const RunTable& table) {
  return select(table, [](const RunResult& run) { return run.setup.choice.strategy != Strategy::nonopt; });
}

/// The run in which this is greatest; there must be one.
const RunResult& worstOf(const RunList& runs, double RunSummary::*of) {
  return **std::ranges::max_element(runs, {}, [of](const RunResult* run) { return run->summary.*of; });
}

Claim ratesBelowLimits(const RunTable& table, Experiment experiment) {
  Claim claim{.id = nameOf(experiment) + "-rates",
              .text = "No joint comes close to its greatest rate: " + nameOf(experiment),
              .seenIf = "no joint exceeds 90 % of its rate limit in any tick of any run"};
  const RunList runs = select(table, [&](const RunResult& run) { return run.setup.experiment == experiment; });
  if (runs.empty()) return claim;
  const RunResult& fastest = worstOf(runs, &RunSummary::greatestRate);
  const RunResult& closest = worstOf(runs, &RunSummary::greatestRateShare);
  const auto over =
      std::ranges::count_if(runs, [](const RunResult* run) { return run->summary.greatestRateShare > kNearLimit; });
  claim.measured = "greatest rate " + text(fastest.summary.greatestRate) + " rad/s (" + fastest.setup.name() +
                   "), greatest share of a limit " + text(100 * closest.summary.greatestRateShare) + " % (" +
                   closest.setup.name() + "); " + std::to_string(over) + " of " + std::to_string(runs.size()) +
                   " runs exceed 90 %";
  claim.values = {{"greatest_rate_rad_per_s", fastest.summary.greatestRate},
                  {"greatest_share_of_limit", closest.summary.greatestRateShare},
                  {"runs_over_90_percent", static_cast<double>(over)}};
  claim.judge(over == 0);
  return claim;
}

/// Adds the greatest tracking error of these runs to the claim, and returns it [m].
double addTracking(Claim& claim, const RunList& runs, const std::string& which) {
  if (runs.empty()) return 0;
  const RunResult& worst = worstOf(runs, &RunSummary::greatestPositionError);
  const double error = worst.summary.greatestPositionError;
  claim.measured += (claim.measured.empty() ? "" : "; ") + std::to_string(runs.size()) + " " + which +
                    " runs: at most " + text(1e3 * error) + " mm (" + worst.setup.name() + ")";
  claim.values.emplace_back("tracking_error_" + which + "_m", error);
  return error;
}

/// Near singular poses the pseudoinverse is damped, which costs accuracy: runs that get there are told apart.
Claim tracking(const RunTable& table) {
  Claim claim{.id = "tracking",
              .text = "Tracking error of the 1 m/s circles is below 0.1 mm at 1 kHz",
              .seenIf =
                  "the tool is never farther from its wanted place in the runs at 1 m/s that are regular: their "
                  "rotational singular values stay above 0.1"};
  const auto ofKind = [&table](bool regular) {
    return select(table, [regular](const RunResult& run) {
      return run.setup.path.speed == 1 && (leastSigmaRot(run) > kRegular) == regular;
    });
  };
  const RunList regular = ofKind(true);
  if (regular.empty()) return claim;
  claim.judge(addTracking(claim, regular, "regular") < kTrackingWanted);
  addTracking(claim, ofKind(false), "singular");
  return claim;
}

Claim selfMotion(const RunTable& table) {
  Claim claim{.id = "self-motion",
              .text = "Null-space motion moves the tool less than 1e-9 m per tick",
              .seenIf =
                  "the tool's velocity by the null-space part of the rates, times the tick, is below that in every "
                  "tick"};
  const RunList runs = optimised(table);
  if (runs.empty()) return claim;
  const RunResult& fastest = worstOf(runs, &RunSummary::selfMotionVelocity);
  const double moved = kTick * fastest.summary.selfMotionVelocity;
  claim.measured = "at most " + text(moved, 2) + " m (" + fastest.setup.name() + ")";
  claim.values = {{"tool_motion_per_tick_m", moved}};
  claim.judge(moved < kSelfMotionWanted);
  return claim;
}

/// Rates are held for a tick, in which the arm leaves the straight line; what the correction of second order leaves.
Claim selfMotionHeld(const RunTable& table) {
  Claim claim{
      .id = "self-motion-held",
      .text = "So it does with rates held for a tick, curvature included",
      .seenIf = "the tool's place after any tick differs by less than 1e-9 m from its place without self-motion"};
  const RunList runs = optimised(table);
  if (runs.empty()) return claim;
  const RunResult& farthest = worstOf(runs, &RunSummary::selfMotionStep);
  const auto over = std::ranges::count_if(
      runs, [](const RunResult* run) { return run->summary.selfMotionStep >= kSelfMotionWanted; });
  claim.measured = "at most " + text(farthest.summary.selfMotionStep, 2) + " m (" + farthest.setup.name() +
                   ", joint rates up to " + text(farthest.summary.greatestRate) + " rad/s); " + std::to_string(over) +
                   " of " + std::to_string(runs.size()) + " runs have a tick over 1e-9 m";
  claim.values = {{"tool_motion_per_tick_m", farthest.summary.selfMotionStep},
                  {"runs_over", static_cast<double>(over)},
                  {"runs", static_cast<double>(runs.size())}};
  claim.judge(over == 0);
  return claim;
}

Claim selfMotionWithinRates(const RunTable& table) {
  Claim claim{.id = "self-motion-rates",
              .text = "The step bounds keep joint rates admissible: self-motion drives no joint beyond its limit",
              .seenIf = "in no tick does a rate of eq. (16) exceed its limit, unless that of least norm does already"};
  const RunList runs = optimised(table);
  if (runs.empty()) return claim;
  const double beyond = worstOf(runs, &RunSummary::rateBeyondBounds).summary.rateBeyondBounds;
  const double held = worstOf(runs, &RunSummary::heldRateBeyondBounds).summary.heldRateBeyondBounds;
  claim.measured = "beyond the bounds by at most " + text(std::max(0., beyond), 2) +
                   " rad/s; with the correction for rates being held for a tick by " + text(std::max(0., held), 2) +
                   " rad/s, which the joint limiter takes off";
  claim.values = {{"rate_beyond_bounds_rad_per_s", beyond}, {"held_rate_beyond_bounds_rad_per_s", held}};
  claim.judge(beyond < kRounding);
  return claim;
}

Claim alwaysFinite(const RunTable& table) {
  Claim claim{.id = "finite",
              .text = "Singular poses included, nothing is ever infinite or NaN",
              .seenIf = "angles, rates and places are finite in every tick"};
  const std::size_t all = table.runs().size();
  if (all == 0) return claim;
  const std::size_t bad = select(table, [](const RunResult& run) { return !run.summary.finite; }).size();
  claim.measured = std::to_string(bad) + " of " + std::to_string(all) + " runs are not finite";
  claim.values = {{"runs", static_cast<double>(all)}, {"runs_not_finite", static_cast<double>(bad)}};
  claim.judge(bad == 0);
  return claim;
}

}  // namespace

std::vector<Claim> controlClaims(const RunTable& table) {
  std::vector<Claim> claims;
  for (const Experiment experiment : {Experiment::circle, Experiment::heights, Experiment::velocities})
    claims.push_back(ratesBelowLimits(table, experiment));
  for (const auto& judge : {tracking, selfMotion, selfMotionHeld, selfMotionWithinRates, alwaysFinite})
    claims.push_back(judge(table));
  return claims;
}

}  // namespace haptiv
