#include "tests/faults/FaultTable.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <sstream>

namespace haptiv::faults {
namespace {

std::string milliseconds(int ticks) {
  return ticks < 0 ? "-" : std::to_string(static_cast<int>(std::lround(ticks * 1000 / kRate)));
}

std::string number(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

std::string foundAs(const Outcome& outcome) {
  if (outcome.faults != kNoFault) return faultList(outcome.faults);
  if (outcome.state != SessionState::running) return std::string("state ") + nameOf(outcome.state);
  return outcome.clamps == kNoClamp ? "no fault: felt smoothly"
                                    : "no fault; clamps " + joined(clampNames(outcome.clamps));
}

std::string row(const Line& line) {
  const Outcome& outcome = line.outcome;
  const bool stops = outcome.state != SessionState::running;
  std::ostringstream text;
  text << "| " << line.of.what << " | " << foundAs(outcome) << " | " << milliseconds(outcome.safe) << " | "
       << (stops ? milliseconds(outcome.atRest) : "-") << " | " << number(outcome.force, 0) << " | "
       << number(outcome.forceStep, 0) << " | " << number(outcome.speed, 2) << " |\n";
  return text.str();
}

constexpr const char* kHead = R"(# The fault table

Each fault is injected into the running chain, with the simulated arm and hand, and what comes of it is measured in simulated time.
This page is written by the tests (`faults_tests`, with `HAPTIV_WRITE_FAULT_TABLE=1`), and a test fails where it differs from what they find.
What the faults, clamps and states are: [safety.md](safety.md).

In most cases the operator presses 20 N on a wall of 2000 N/m, or carries the ball at 1 m/s, at 1 kHz. *Brakes* is the time from the injection to the first
command that brakes; 1 ms is the same tick. *At rest* is the time until the tool stands still. *Force* is the largest of the scene on the ball from the
injection on, *step* its largest change from tick to tick, *speed* the largest of the tool, whatever the host is told. A dash: the session goes on.

Limits, which nothing leaves: %FORCE% N for the scene's force, %SPEED% m/s for the tool. What a hand itself pulls and pushes with is not for the arm to bound:
between hand and handle there were up to %HAND% N, of a hand that can give 170 N and has a mass of its own.
)";

constexpr const char* kColumns =
    "| injected | found as | brakes [ms] | at rest [ms] | force [N] | step [N] | speed [m/s] |\n"
    "|---|---|---|---|---|---|---|\n";

double largestHandForce(const std::vector<Section>& sections) {
  double largest = 0;
  for (const Section& section : sections)
    for (const Line& line : section.lines) largest = std::max(largest, line.outcome.handForce);
  return largest;
}

void replace(std::string& text, const std::string& mark, const std::string& by) {
  text.replace(text.find(mark), mark.size(), by);
}

/// A line's words, and its numbers apart.
struct Taken {
  std::string words;
  std::vector<double> numbers;
};

Taken apart(const std::string& line) {
  Taken taken;
  for (const char* at = line.c_str(); *at != 0;) {
    char* end = nullptr;
    const bool digit = *at >= '0' && *at <= '9';
    const double value = digit ? std::strtod(at, &end) : 0;
    if (digit) taken.numbers.push_back(value);
    taken.words += digit ? '#' : *at;
    at = digit ? end : at + 1;
  }
  return taken;
}

bool sameLine(const std::string& a, const std::string& b) {
  const Taken left = apart(a), right = apart(b);
  const auto near = [](double x, double y) {
    const bool whole = x == std::floor(x) && y == std::floor(y);
    return std::abs(x - y) <= std::max(0.2 * std::max(x, y), whole ? 5.0 : 0.05);
  };
  return left.words == right.words &&
         std::equal(left.numbers.begin(), left.numbers.end(), right.numbers.begin(), right.numbers.end(), near);
}

}  // namespace

std::string faultTable(const std::vector<Section>& sections, const std::vector<ProgramCase>& program) {
  const SafetyThresholds safety = FaultChain().description.safety;
  std::string text = kHead;
  replace(text, "%FORCE%", number(safety.forceClamp, 0));
  replace(text, "%SPEED%", number(safety.speedClamp, 1));
  replace(text, "%HAND%", number(largestHandForce(sections), 0));
  for (const Section& section : sections) {
    text += "\n## " + section.name + "\n\n" + kColumns;
    for (const Line& line : section.lines) text += row(line);
  }
  text += "\n## The program beside the servo\n\n| injected | the servo | afterwards |\n|---|---|---|\n";
  for (const ProgramCase& each : program)
    text += "| " + each.what + " | " + (each.unnoticed ? "does not notice" : "STOPS") + " | " + each.told + " |\n";
  return text;
}

bool sameTable(const std::string& a, const std::string& b, std::string& difference) {
  std::istringstream left(a), right(b);
  for (std::string x, y;;) {
    const bool more = static_cast<bool>(std::getline(left, x)), others = static_cast<bool>(std::getline(right, y));
    if (!more && !others) return true;
    if (more != others || !sameLine(x, y)) {
      difference = "  " + x + "\n  " + y;
      return false;
    }
  }
}

}  // namespace haptiv::faults
