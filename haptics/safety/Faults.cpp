#include "haptics/safety/Faults.h"

#include <array>
#include <bit>

#include "device/types.h"

namespace haptiv {
namespace {

constexpr int kFirstTrip = std::countr_zero(std::uint32_t{kFaultTripWatchdog});
constexpr std::uint32_t kKnownTrips = (1u << kTripCount) - 1;
constexpr std::uint32_t kJoints = tripJoints(0xFFFF);
static_assert(kTripWatchdog << kFirstTrip == kFaultTripWatchdog && kTripPower << kFirstTrip == kFaultTripPower);

constexpr std::array<const char*, kFaultCount> kNames = {
    "not finite",
    "tracking error",
    "sensor saturated",
    "device disconnected",
    "sensor stuck",
    "encoder jump",
    "encoder stuck",
    "joint too fast",
    "hand force implausible",
    "missed ticks",
    "runaway",
    "oscillation",
    "emergency stop",
    "device trip: watchdog",
    "device trip: joint too fast",
    "device trip: emergency stop",
    "device trip: dead-man released",
    "device trip: encoder",
    "device trip: impossible command",
    "device trip: asked for by the host",
    "device trip: power",
    "device trip: unknown",
    "tool too fast",
};

}  // namespace

std::uint32_t faultsOfTrips(std::uint32_t trips) noexcept {
  const std::uint32_t known = (trips & kKnownTrips) << kFirstTrip;
  return (trips & ~(kKnownTrips | kJoints)) != 0 ? known | kFaultTripUnknown : known;
}

const char* faultName(Fault fault) noexcept {
  if (fault == kNoFault) return "none";
  const auto first = static_cast<std::size_t>(std::countr_zero(static_cast<std::uint32_t>(fault)));
  return first < kNames.size() ? kNames[first] : "unknown fault";
}

std::vector<std::string> faultNames(std::uint32_t faults) {
  std::vector<std::string> names;
  for (; faults != 0; faults &= faults - 1) names.emplace_back(faultName(static_cast<Fault>(faults)));
  return names;
}

std::string faultList(std::uint32_t faults) {
  std::string list;
  for (const std::string& name : faultNames(faults)) list += (list.empty() ? "" : ", ") + name;
  return list.empty() ? faultName(kNoFault) : list;
}

std::vector<std::string> tripNames(std::uint32_t trips) {
  constexpr std::size_t kPrefix = sizeof("device trip: ") - 1;
  std::vector<std::string> names = faultNames(faultsOfTrips(trips));
  for (std::string& name : names) name.erase(0, kPrefix);
  for (int joint = 0; joint < kJointCount; ++joint)
    if ((trips & tripJoints(static_cast<std::uint16_t>(1u << joint))) != 0)
      names.push_back("joint " + std::to_string(joint + 1));
  return names;
}

}  // namespace haptiv
