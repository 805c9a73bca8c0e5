#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "device/simulated/SimulatedDevice.h"
#include "haptics/tick/HapticTick.h"

namespace haptiv::faults {

inline constexpr double kRate = 1000;  ///< [Hz]

/// What the simulated operator does, for a case to change while it runs.
struct Operator {
  HandTarget target;  ///< in B
};

/// What came of a fault.
struct Outcome {
  std::uint32_t faults = kNoFault;  ///< that stand in the end
  std::uint32_t clamps = kNoClamp;  ///< that held since the injection
  SessionState state = SessionState::idle;
  int found = -1;        ///< ticks from the injection to the first that tells the fault, itself included; -1: never
  int safe = -1;         ///< likewise to the first command that brakes
  int atRest = -1;       ///< likewise until the tool stands still for good
  double force = 0;      ///< largest of the scene on the ball since the injection [N]
  double speed = 0;      ///< largest of the real tool since then [m/s]
  double forceStep = 0;  ///< largest from tick to tick since then [N]
  double handForce = 0;  ///< largest between hand and handle since then [N]
};

/// Device and tick in simulated time, with a case's hand between them. The arm stands at home, a wall 50 mm before it.
class FaultChain {
 public:
  FaultChain();

  // To be changed before the run, and by the case while it runs.
  DeviceDescription description;
  HapticScene scene;
  Operator hand;
  DeviceReading reading;          ///< as the host gets it: spoil it here
  bool hostSilent = false;        ///< the device gets no commands: its board does not hear the host
  std::uint32_t missedTicks = 0;  ///< that the servo has skipped so far

  const Vector3& home() const { return home_; }
  double time() const { return static_cast<double>(ticks_) / kRate; }  ///< [s]

  /// Changes something before each tick; `since` counts the ticks since the injection, negative before it.
  using Script = std::function<void(FaultChain&, int since)>;
  /// @param injectAt  [s]
  /// @param goesOn    after the injection [s]
  Outcome run(double injectAt, double goesOn, const Script& script);

 private:
  Vector3 home_;
  std::int64_t ticks_ = 0;
};

/// The hand presses the ball 20 N into the wall, from 0.8 s on.
void pressOnWall(FaultChain& chain);
/// The hand carries the ball along y: at 1 s it passes home at about 1 m/s.
void carryFast(FaultChain& chain);

}  // namespace haptiv::faults
