#include "haptics/servo/SessionStart.h"

#include "device/kinematics/ArmKinematics.h"
#include "haptics/scene/DeviceFrames.h"

namespace haptiv {
namespace {

constexpr double kTolerance = 1e-6;  // [m]; the inverse function is good to rounding, or misses by far more

}  // namespace

bool SessionStart::inReach() const {
  return (reached - wanted).norm() <= kTolerance;
}

SessionStart sessionStart(const HapticScene& scene, const DeviceDescription& device) {
  const ArmKinematics arm(device);
  SessionStart start;
  start.wanted = placeInBase(scene.device, scene.tool.home);
  start.angles = arm.inverse(start.wanted, device.homeAngles);
  start.reached = arm.forward(start.angles).position;
  return start;
}

}  // namespace haptiv
