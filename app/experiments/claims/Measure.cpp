#include "app/experiments/claims/Measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace haptiv {
namespace {

std::string print(const char* format, int digits, double number) {
  std::array<char, 48> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, digits, number);
  return buffer.data();
}

}  // namespace

Runs circles(const RunTable& table, const ResolutionChoice& choice) {
  return table.all(Experiment::circle, choice, kRadii);
}

std::string text(double number, int digits) {
  return print("%.*g", digits, number);
}
std::string fixed(double number) {
  return print("%.*f", 2, number);
}
std::string gainText(double with, double without) {
  return print("%+.*f %%", 0, 100 * (with / without - 1));
}

double leastSigmaRot(const RunResult& run) {
  return run.summary.leastSigmaRot;
}
double meanTrans(const RunResult& run) {
  return run.summary.meanIndexTrans;
}
double meanRot(const RunResult& run) {
  return run.summary.meanIndexRot;
}

std::string whySigmaFalls(const RunResult& run) {
  const double start = run.samples.front().sigmaRot[2];
  return "from " + text(start) + " at the start to " + text(leastSigmaRot(run)) +
         " at t = " + text(run.summary.leastSigmaRotTime) + " s of " + run.setup.name();
}

Claim optimisedStaysRegular(const RunTable& table, Experiment experiment) {
  const std::string which = nameOf(experiment);
  Claim claim{.id = which + "-full-regular",
              .text = "The optimised full solution keeps the rotational stage regular at every " +
                      std::string(experiment == Experiment::heights ? "height" : "velocity"),
              .seenIf = "the least rotational singular value stays above 0.1, for man, dir and cond"};
  double least = HUGE_VAL;
  for (const Strategy strategy : kCriteria) {
    const auto runs = experiment == Experiment::heights ? table.all(experiment, full(strategy), kHeights)
                                                        : table.all(experiment, full(strategy), kSpeeds);
    if (!runs) return claim;
    claim.measured += (claim.measured.empty() ? "" : "; ") + nameOf(strategy) + " " + listText(*runs, leastSigmaRot);
    for (const RunResult* run : *runs) {
      claim.values.emplace_back("sigma_min_rot_" + nameOf(strategy) + "_" + fixed(run->setup.varied),
                                leastSigmaRot(*run));
      least = std::min(least, leastSigmaRot(*run));
    }
  }
  claim.judge(least > kRegular);
  return claim;
}

}  // namespace haptiv
