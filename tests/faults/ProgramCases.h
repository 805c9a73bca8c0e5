#pragma once

#include <string>
#include <vector>

namespace haptiv::faults {

/// A part of the program that fails beside the servo, which must not notice.
struct ProgramCase {
  std::string what;
  bool unnoticed = false;  ///< every tick was run, and none told a fault
  std::string told;        ///< what the session says of it afterwards
};

/// Log writer, disk and window fail while a servo runs. Throws where a session cannot be run.
std::vector<ProgramCase> programFaults();

}  // namespace haptiv::faults
