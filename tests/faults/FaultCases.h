#pragma once

#include <string>
#include <vector>

#include "tests/faults/FaultChain.h"

namespace haptiv::faults {

/// One line of the fault table.
struct FaultCase {
  std::string what;                 ///< is injected
  std::uint32_t faults = kNoFault;  ///< that must stand then; none: none may
  std::uint32_t clamps = kNoClamp;  ///< that must hold at some time
  SessionState ends = SessionState::fault;
  int within = 1;  ///< ticks until the fault is found, at the most
  FaultChain::Script script;
  double injectAt = 1;                     ///< [s]
  double goesOn = 0.5;                     ///< after the injection [s]
  void (*arrange)(FaultChain&) = nullptr;  ///< what is otherwise from the start
};

/// Cases that belong together, with their heading.
struct FaultGroup {
  std::string name;
  std::vector<FaultCase> cases;
};

FaultGroup operatorFaults();
FaultGroup sensorFaults();
FaultGroup encoderFaults();
FaultGroup connectionFaults();
FaultGroup tripFaults();
FaultGroup sceneFaults();
FaultGroup clampCases();
FaultGroup stabilityFaults();
FaultGroup calmCases();

}  // namespace haptiv::faults
