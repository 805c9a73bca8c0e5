#pragma once

#include "device/types.h"

namespace haptiv {

/// What is broken in a simulated device, to see how board and host take it. All at once if need be; a default one is a
/// whole device. Bit i of a mask is axis i of the sensor (force x y z, torque x y z) or joint i + 1.
struct InjectedFaults {
  std::uint8_t sensorStuck = 0;      ///< these axes report the same count again and again
  std::uint8_t sensorSaturated = 0;  ///< these report the end of their range
  std::uint8_t sensorDead = 0;       ///< these report zero, as of a broken wire

  std::uint16_t encoderStuck = 0;                       ///< these joints' counts stay, however they turn
  std::array<std::int32_t, kJointCount> encoderJump{};  ///< counts that are added, as by a lost index
  std::uint16_t encoderBroken = 0;                      ///< the board's decoder sees that these wires are broken
  std::uint16_t motorDead = 0;                          ///< these amplifiers give no torque; their motors turn freely

  bool powerLost = false;     ///< supply or temperature of the drives out of their bounds
  bool boardFrozen = false;   ///< the board says the same for ever and hears nothing; its outputs fall off: brakes
  bool disconnected = false;  ///< readings and commands are lost on the way; the board lives, its watchdog too
  bool hostSilent = false;    ///< commands are lost on the way, readings come: as a host that hangs
};

}  // namespace haptiv
