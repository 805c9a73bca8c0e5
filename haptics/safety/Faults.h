#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "device/safety/SafetySignals.h"

namespace haptiv {

/// What makes a session stop; bits, so that several can stand. docs/safety.md tells each in words.
enum Fault : std::uint32_t {
  kNoFault = 0,
  // What the host finds.
  kFaultNotFinite = 1u << 0,        ///< a value of the tick was NaN or infinite
  kFaultTracking = 1u << 1,         ///< a joint is too far from where it was sent
  kFaultSensorSaturated = 1u << 2,  ///< the handle's sensor is at the end of its range
  kFaultDisconnected = 1u << 3,     ///< the device does not answer
  kFaultSensorStuck = 1u << 4,      ///< a noisy axis of the handle's sensor repeats one count
  kFaultEncoderJump = 1u << 5,      ///< an encoder went further within a tick than the joint can
  kFaultEncoderStuck = 1u << 6,     ///< an encoder stands still while its joint is sent on
  kFaultJointSpeed = 1u << 7,       ///< a joint counts more impulses than the reference counter allows
  kFaultHandForce = 1u << 8,        ///< the sensor tells more than a hand can
  kFaultMissedTicks = 1u << 9,      ///< the servo has missed too many ticks
  kFaultRunaway = 1u << 10,         ///< the virtual mass stays at the speed clamp though no hand pushes it
  kFaultOscillation = 1u << 11,     ///< it swings fast and does not die down: contact is not stable
  kFaultEmergencyStop = 1u << 12,   ///< one of the buttons, as the host reads it
  // What the device's own circuit tells: the bits of Trip.
  kFaultTripWatchdog = 1u << 13,
  kFaultTripOverspeed = 1u << 14,
  kFaultTripEmergencyStop = 1u << 15,
  kFaultTripDeadMan = 1u << 16,
  kFaultTripEncoder = 1u << 17,
  kFaultTripCommand = 1u << 18,
  kFaultTripHost = 1u << 19,
  kFaultTripPower = 1u << 20,
  kFaultTripUnknown = 1u << 21,  ///< a device that is newer than this program
  // What the host finds, again.
  kFaultToolSpeed = 1u << 22,  ///< the tool comes near speedClamp, though it is sent more slowly
};
inline constexpr int kFaultCount = 23;
inline constexpr int kTripCount = 8;  ///< known Trip bits

/// The faults that these trips are. Realtime-safe: yes.
std::uint32_t faultsOfTrips(std::uint32_t trips) noexcept;

/// Name of one fault; of several, the first one's; "none" where there is none. A literal. Realtime-safe: yes.
const char* faultName(Fault fault) noexcept;
/// Names of all faults that stand, the first bit first.
std::vector<std::string> faultNames(std::uint32_t faults);
/// The same, comma separated; "none" where there are none.
std::string faultList(std::uint32_t faults);
/// Names of the device's trips that stand, with the joints that they are about: "joint too fast", "joint 3".
std::vector<std::string> tripNames(std::uint32_t trips);

}  // namespace haptiv
