#include "tests/faults/FaultTable.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace haptiv::faults {
namespace {

const std::string kPage = std::string(HAPTIV_SOURCE_DIR) + "/docs/faults.md";

Section ran(const FaultGroup& group) {
  Section section{group.name, {}};
  for (const FaultCase& each : group.cases) {
    FaultChain chain;
    if (each.arrange != nullptr) each.arrange(chain);
    section.lines.push_back({each, chain.run(each.injectAt, each.goesOn, each.script)});
  }
  return section;
}

const std::vector<Section>& sections() {
  static const std::vector<Section> all = {ran(operatorFaults()),   ran(sensorFaults()),    ran(encoderFaults()),
                                           ran(connectionFaults()), ran(tripFaults()),      ran(sceneFaults()),
                                           ran(clampCases()),       ran(stabilityFaults()), ran(calmCases())};
  return all;
}

template <typename Check>
void forEachLine(Check check) {
  for (const Section& section : sections())
    for (const Line& line : section.lines) {
      SCOPED_TRACE(section.name + ": " + line.of.what);
      check(line);
    }
}

TEST(FaultTable, HasEveryFaultFoundAndNamed) {
  std::size_t count = 0;
  forEachLine([&](const Line& line) {
    ++count;
    EXPECT_EQ(line.outcome.state, line.of.ends) << nameOf(line.outcome.state);
    EXPECT_EQ(line.outcome.faults & line.of.faults, line.of.faults) << faultList(line.outcome.faults);
    if (line.of.faults == kNoFault) {
      EXPECT_EQ(line.outcome.faults, kNoFault) << faultList(line.outcome.faults);
    }
    if (line.of.clamps != kNoClamp) {
      EXPECT_NE(line.outcome.clamps & line.of.clamps, kNoClamp);
    }
    if (line.of.faults != kNoFault) {
      EXPECT_LE(line.outcome.found, line.of.within);
    }
  });
  EXPECT_GE(count, 25u);
}

TEST(FaultTable, BrakesInTheTickThatFindsTheFault) {
  forEachLine([](const Line& line) {
    if (line.of.ends == SessionState::running) return;
    ASSERT_GT(line.outcome.safe, 0);
    if (line.of.faults != kNoFault) {
      EXPECT_EQ(line.outcome.safe, line.outcome.found);
    }
    EXPECT_GT(line.outcome.atRest, 0);
  });
}

TEST(FaultTable, NeverLeavesTheClamps) {
  const SafetyThresholds safety = FaultChain().description.safety;
  forEachLine([&](const Line& line) {
    EXPECT_LE(line.outcome.force, safety.forceClamp + 1e-9);
    EXPECT_LE(line.outcome.speed, safety.speedClamp);
  });
}

TEST(FaultTable, HasAServoThatDoesNotNoticeTheRestOfTheProgram) {
  for (const ProgramCase& each : programFaults()) EXPECT_TRUE(each.unnoticed) << each.what;
}

TEST(FaultTable, IsTheOneInTheDocuments) {
  const std::string now = faultTable(sections(), programFaults());
  if (std::getenv("HAPTIV_WRITE_FAULT_TABLE") != nullptr) std::ofstream(kPage, std::ios::trunc) << now;
  std::ifstream stream(kPage);
  const std::string page{std::istreambuf_iterator<char>(stream), {}};
  std::string difference;
  EXPECT_TRUE(sameTable(page, now, difference))
      << "docs/faults.md is not what the faults do now. Run this test with HAPTIV_WRITE_FAULT_TABLE=1, and look at "
      << "what has changed:\n"
      << difference;
}

TEST(FaultTable, TellsTablesThatDiffer) {
  std::string difference;
  EXPECT_TRUE(sameTable("| a | 100 | 0.52 |", "| a | 104 | 0.55 |", difference));
  EXPECT_FALSE(sameTable("| a | 100 |", "| a | 150 |", difference));
  EXPECT_FALSE(sameTable("| a | 1 |", "| b | 1 |", difference));
  EXPECT_FALSE(sameTable("| a |", "| a |\n| b |", difference));
}

}  // namespace
}  // namespace haptiv::faults
