#pragma once

#include <cstdint>

/// What device and host tell each other about safety, as bits, so that several can stand at a time.
namespace haptiv {

/// What the operator's buttons say in a reading; as wired, not latched.
enum OperatorInput : std::uint16_t {
  kInputDeadMan = 1u << 0,         ///< pressed: the operator is there (a button on the handle, or a foot pedal)
  kInputEmergencyStop1 = 1u << 1,  ///< pressed; several of them, wherever a person may stand
  kInputEmergencyStop2 = 1u << 2,
  kInputEmergencyStop3 = 1u << 3,
  kInputEmergencyStop4 = 1u << 4,
  kInputReset = 1u << 5,  ///< the operator asks to go on after a fault
};
inline constexpr std::uint16_t kInputEmergencyStops =
    kInputEmergencyStop1 | kInputEmergencyStop2 | kInputEmergencyStop3 | kInputEmergencyStop4;

/// Why the device's own safety circuit has bypassed the motors                       [paper, section III.D]
/// Latched in the device, independent of the host; cleared by the operator's reset alone.
enum Trip : std::uint32_t {
  kNoTrip = 0,
  kTripWatchdog = 1u << 0,       ///< no valid command with a changed heartbeat in time: the host hangs
  kTripOverspeed = 1u << 1,      ///< a joint counted more encoder impulses than the reference counter allows
  kTripEmergencyStop = 1u << 2,  ///< one of the buttons
  kTripDeadMan = 1u << 3,        ///< it was released, and the host went on enabling the drives
  kTripEncoder = 1u << 4,        ///< an encoder is silent or jumps
  kTripCommand = 1u << 5,        ///< set-points that no drive can follow, or that are no numbers
  kTripHost = 1u << 6,           ///< the host asked for it
  kTripPower = 1u << 7,          ///< supply or temperature of the drives
};

/// The trips' upper half says which joints were too fast or had a faulty encoder: bit 16 is joint 1.
constexpr std::uint32_t tripJoints(std::uint16_t joints) {
  return static_cast<std::uint32_t>(joints) << 16;
}

}  // namespace haptiv
