#include "app/experiments/claims/Claims.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/experiments/Simulation.h"
#include "app/experiments/claims/ClaimsText.h"

namespace haptiv {
namespace {

const Claim& named(const std::vector<Claim>& claims, const std::string& id) {
  return *std::ranges::find(claims, id, &Claim::id);
}

// Circles of the full solution that were never run: with these least rotational singular values.
std::vector<RunResult> circles(Strategy strategy, const std::vector<double>& sigmas) {
  std::vector<RunResult> runs;
  for (std::size_t i = 0; i < sigmas.size(); ++i) {
    RunResult& run = runs.emplace_back();
    run.setup.varied = kRadii[i];
    run.setup.choice = {strategy, Solution::full};
    run.samples.emplace_back().sigmaRot = Vector3::Constant(0.647);
    run.summary.leastSigmaRot = sigmas[i];
  }
  return runs;
}

Verdict verdictOn(const std::string& id, std::vector<RunResult> runs) {
  return named(judgeClaims(RunTable(std::move(runs), {})), id).verdict;
}

TEST(Claims, SingularRadiiAreSeenWhereTheyAreExactlyThePapers) {
  const std::string id = "circle-full-nonopt-singular";
  EXPECT_EQ(verdictOn(id, circles(Strategy::nonopt, {0.6, 0.6, 0.001, 0.001, 0.001})), Verdict::seen);
  EXPECT_EQ(verdictOn(id, circles(Strategy::nonopt, {0.6, 0.001, 0.001, 0.001, 0.001})), Verdict::notSeen);
  EXPECT_EQ(verdictOn(id, circles(Strategy::nonopt, {0.6, 0.6, 0.6, 0.001, 0.001})), Verdict::notSeen);
}

TEST(Claims, ACriterionKeepsItsSigmaAtAllRadiiOrTheTableSaysWhereNot) {
  const std::string id = "circle-full-man-sigma";
  EXPECT_EQ(verdictOn(id, circles(Strategy::man, {0.6, 0.6, 0.31, 0.6, 0.6})), Verdict::seen);
  const std::vector<Claim> claims = judgeClaims(RunTable(circles(Strategy::man, {0.6, 0.6, 0.29, 0.6, 0.6}), {}));
  EXPECT_EQ(named(claims, id).verdict, Verdict::notSeen);
  EXPECT_NE(named(claims, id).measured.find("circle-full-man-r0.40"), std::string::npos) << named(claims, id).measured;
}

TEST(Claims, AreNotRunWhereARunIsMissing) {
  EXPECT_EQ(verdictOn("circle-full-nonopt-singular", circles(Strategy::nonopt, {0.6, 0.6, 0.001, 0.001})),
            Verdict::notRun);
  for (const Claim& claim : judgeClaims(RunTable({}, {}))) {
    EXPECT_EQ(claim.verdict, Verdict::notRun) << claim.id;
    EXPECT_TRUE(claim.measured.empty() && claim.values.empty()) << claim.id;
  }
}

TEST(Claims, HaveIdsOfTheirOwn) {
  std::vector<std::string> ids;
  for (const Claim& claim : judgeClaims(RunTable({}, {}))) ids.push_back(claim.id);
  std::ranges::sort(ids);
  EXPECT_EQ(std::ranges::adjacent_find(ids), ids.end());
  EXPECT_GE(ids.size(), 25u);
}

TEST(Claims, OfAShortenedRealRunHoldThePartitionedStageStill) {
  const DeviceDescription device = loadDeviceDescription("vishard10");
  const RedundancyResolution resolution(device);
  std::vector<RunResult> runs;
  for (RunSetup& setup : runsOf(Experiment::circle, device, {{Strategy::nonopt, Solution::partitioned}})) {
    setup.duration = 0.1;
    runs.push_back(simulate(setup, device, resolution));
  }
  const std::vector<Claim> claims = judgeClaims(RunTable(std::move(runs), {}));
  for (const char* id : {"circle-partitioned-nonopt-constant", "tracking", "finite"})
    EXPECT_EQ(named(claims, id).verdict, Verdict::seen) << id << ": " << named(claims, id).measured;
}

TEST(ClaimsText, GivesEachClaimARowWithItsVerdict) {
  std::vector<Claim> claims(3);
  claims[0] = {"a", "first", "if a", "1 m", {{"length_m", 1}}, Verdict::seen};
  claims[1] = {"b", "second", "if b", "2 m", {}, Verdict::notSeen};
  claims[2] = {"c", "third", "if c"};
  const std::string page = claimsToMarkdown(claims);
  EXPECT_NE(page.find("| first | 1 m | **seen** | if a |"), std::string::npos) << page;
  EXPECT_NE(page.find("| second | 2 m | **not seen** | if b |"), std::string::npos) << page;
  EXPECT_NE(page.find("| third | - | **not run** | if c |"), std::string::npos) << page;
  const auto json = nlohmann::json::parse(claimsToJson(claims)).at("claims");
  ASSERT_EQ(json.size(), 3u);
  EXPECT_EQ(json[0].at("verdict"), "seen");
  EXPECT_EQ(json[0].at("values").at("length_m"), 1);
  EXPECT_EQ(json[2].at("verdict"), "not run");
}

}  // namespace
}  // namespace haptiv
