#pragma once

#include "device/HapticDevice.h"

namespace haptiv {

/// What the wires bring to the interface board.
struct BoardInputs {
  std::array<std::int32_t, kJointCount> encoderCounts{};
  std::array<std::int16_t, 6> sensorCounts{};
  std::uint16_t buttons = 0;        ///< OperatorInput bits
  std::uint16_t encoderFaults = 0;  ///< bit i: the decoder of joint i + 1 saw a broken wire or a forbidden transition
  bool powerGood = true;            ///< supply and temperature of the drives are in their bounds
};

/// What the host asks of the board, once its frame has been found whole.
struct BoardCommand {
  std::uint32_t sequence = 0;   ///< grows with every frame
  std::uint32_t heartbeat = 0;  ///< changes with every tick of the host's servo, and only then
  DeviceCommand drive;
  bool reset = false;  ///< the operator asks at the host to go on after a fault
  bool trip = false;   ///< the host asks for the safety circuit: the same as an emergency stop
};

/// What the board made of a command.
enum class Acceptance : std::uint8_t {
  accepted,
  sameHeartbeat,  ///< the host's servo has not ticked: neither set-points nor watchdog
  outOfOrder,     ///< older than the last one, or the same once more
  notFinite,      ///< a set-point is no number: refused, and the drives are stopped
};

/// What the board does to the drives. Braked: the motors are bypassed and act as brakes.
struct DriveDemand {
  bool braked = true;
  DriveMode mode = DriveMode::rate;
  JointVector setPoints = JointVector::Zero();  ///< [rad/s] or [N m]; finite, within the drives' limits, zero if braked
};

/// What became of the frames that reached the board.
struct BoardCounters {
  std::uint32_t accepted = 0;
  std::uint32_t sameHeartbeat = 0;
  std::uint32_t outOfOrder = 0;
  std::uint32_t notFinite = 0;
  std::uint32_t clamped = 0;  ///< accepted commands of which a set-point was cut to its limit
  std::uint32_t damaged = 0;  ///< frames of a wrong length, magic, version or CRC
};

/// What the board tells the host.
struct BoardReport {
  DeviceReading reading;
  std::int64_t time = 0;           ///< the board's clock [us]
  std::uint32_t lastSequence = 0;  ///< of the newest command that was accepted
  std::uint32_t watchdogLeft = 0;  ///< until the watchdog stops the drives [us]
  bool driving = false;
  bool armed = false;  ///< the operator's dead-man has been pressed since the last stop
  BoardCounters counters;
};

}  // namespace haptiv
