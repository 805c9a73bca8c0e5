#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/experiments/claims/Claims.h"
#include "app/experiments/claims/Measure.h"

namespace haptiv {
namespace {

constexpr double kSame = 0.15;  // relative difference of two means
constexpr double kDegree = std::numbers::pi / 180;

Runs heights(const RunTable& table, const ResolutionChoice& choice) {
  return table.all(Experiment::heights, choice, kHeights);
}

Claim fullGainsAwayFromZero(const RunTable& table) {
  Claim claim{.id = "heights-full-gains",
              .text = "The full solution gains most translational dexterity away from z = 0",
              .seenIf =
                  "with dir, its mean translational index over the partitioned one's is greater at z = -0.3 and "
                  "-0.15 m than at 0, and above 1"};
  const Runs whole = heights(table, full(Strategy::dir)), parts = heights(table, partitioned(Strategy::dir));
  if (!whole || !parts) return claim;
  const auto normalised = [&table](const RunResult& run) { return meanTrans(run) / table.scale().trans; };
  std::vector<double> gain;
  for (std::size_t i = 0; i < whole->size(); ++i) {
    gain.push_back(meanTrans(*(*whole)[i]) / meanTrans(*(*parts)[i]));
    claim.values.emplace_back("gain_z" + fixed(kHeights[i]), gain.back());
  }
  claim.measured =
      "normalised mean at z [m] full " + listText(*whole, normalised) + "; partitioned " + listText(*parts, normalised);
  claim.judge(std::min(gain[0], gain[1]) > std::max(1., gain[2]));
  return claim;
}

Claim linksStretch(const RunTable& table) {
  Claim claim{.id = "heights-full-stretch",
              .text = "It does so by stretching links 6 and 7: |th7| gets small",
              .seenIf = "with dir, full solution, |th7| falls below half of its start at z = -0.3 and -0.15 m"};
  const Runs runs = heights(table, full(Strategy::dir));
  if (!runs) return claim;
  bool seen = true;
  for (const RunResult* run : *runs) {
    const double start = run->summary.startBend7, least = run->summary.leastBend7;
    claim.measured += (claim.measured.empty() ? "z = " : "; z = ") + text(run->setup.varied, 2) + " m: from " +
                      text(start / kDegree) + " to " + text(least / kDegree) + " deg";
    claim.values.emplace_back("bend7_min_rad_z" + fixed(run->setup.varied), least);
    if (run->setup.varied < 0) seen = seen && least < start / 2;
  }
  claim.judge(seen);
  return claim;
}

Claim trappedAtZero(const RunTable& table) {
  Claim claim{.id = "heights-full-trapped",
              .text = "At z = 0 the full solution is trapped in a local minimum and equals the partitioned one",
              .seenIf = "with dir, th7 stays within 1 deg of -180 deg and the mean indices differ by less than 15 %"};
  const RunResult* whole = table.find(Experiment::heights, full(Strategy::dir), 0);
  const RunResult* parts = table.find(Experiment::heights, partitioned(Strategy::dir), 0);
  if (!whole || !parts) return claim;
  const auto relative = [](double a, double b) { return 2 * std::abs(a - b) / (a + b); };
  const double trans = relative(meanTrans(*whole), meanTrans(*parts));
  const double rot = relative(meanRot(*whole), meanRot(*parts));
  const double left = std::numbers::pi - whole->summary.leastBend7;
  claim.measured = "th7 leaves -180 deg by at most " + text(left / kDegree, 2) + " deg; the means differ by " +
                   text(100 * trans, 2) + " % (translational) and " + text(100 * rot, 2) + " % (rotational)";
  claim.values = {{"bend7_departure_rad", left}, {"trans_difference", trans}, {"rot_difference", rot}};
  claim.judge(left < kDegree && trans < kSame && rot < kSame);
  return claim;
}

Claim partitionedSameMotion(const RunTable& table) {
  Claim claim{
      .id = "heights-partitioned-same-motion",
      .text = "Partitioned solution: the motion of the SCARA joints is the same at all heights, and so is the wrist's",
      .seenIf = "with dir, th1..th4, th5*, th8*, th9 and th10 differ by less than 1e-6 rad"};
  const Runs runs = heights(table, partitioned(Strategy::dir));
  if (!runs) return claim;
  const auto decoupled = [](const JointVector& q) {
    Eigen::Matrix<double, 8, 1> angles;
    angles << q.head<4>(), q.head<5>().sum(), q.segment<3>(5).sum(), q[8], q[9];
    return angles;
  };
  const std::vector<RunSample>& first = runs->front()->samples;
  double most = 0;
  for (const RunResult* run : *runs) {
    for (std::size_t i = 0; i < std::min(first.size(), run->samples.size()); ++i)
      most = std::max(most, (decoupled(run->samples[i].q) - decoupled(first[i].q)).cwiseAbs().maxCoeff());
  }
  claim.measured = "greatest difference " + text(most, 2) + " rad";
  claim.values = {{"difference_rad", most}};
  claim.judge(most < 1e-6);
  return claim;
}

}  // namespace

std::vector<Claim> heightClaims(const RunTable& table) {
  return {fullGainsAwayFromZero(table), linksStretch(table), trappedAtZero(table), partitionedSameMotion(table),
          optimisedStaysRegular(table, Experiment::heights)};
}

}  // namespace haptiv
