#pragma once

#include <string>
#include <vector>

#include "tests/faults/FaultCases.h"
#include "tests/faults/ProgramCases.h"

namespace haptiv::faults {

/// A case with what came of it.
struct Line {
  FaultCase of;
  Outcome outcome;
};

struct Section {
  std::string name;
  std::vector<Line> lines;
};

/// docs/faults.md.
std::string faultTable(const std::vector<Section>& sections, const std::vector<ProgramCase>& program);

/// Whether two tables say the same: words exactly, numbers within a fifth, or 5 of their last digit.
/// @param difference  out: the first line that differs
bool sameTable(const std::string& a, const std::string& b, std::string& difference);

}  // namespace haptiv::faults
