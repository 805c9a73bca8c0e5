#pragma once

#include <memory>

#include "device/kinematics/Vishard10.h"
#include "device/simulated/ScriptedHand.h"
#include "haptics/scene/HapticScene.h"

namespace haptiv::test {

/// A wall of 2000 N/m before the arm's home, and a hand that pushes against it along x.
class WallBeforeHome {
 public:
  explicit WallBeforeHome(const DeviceDescription& description)
      : home_(Vishard10(description.links).forward(description.homeAngles).position),
        handStiffness_(description.hand.stiffness) {
    Wall wall;
    wall.id = 1;
    wall.shape.centre = home_ + Vector3(kFace + 0.05, 0, 0);
    wall.shape.axes = Vector3(0.05, 0.3, 0.3).asDiagonal();
    scene_.walls = {wall};
    computeBounds(scene_);
  }

  const HapticScene& scene() const { return scene_; }
  /// Goes into the wall within a second, and then pushes with so many newtons.
  std::unique_ptr<HandSource> pushedBy(double force) const {
    const double rest = kFace - kRadius + force / kStiffness;
    const Vector3 target = home_ + Vector3(rest + force / handStiffness_, 0, 0);
    return std::make_unique<ScriptedHand>(std::vector<HandWaypoint>{{0, home_}, {1, target}});
  }
  /// Of the ball in the wall [m]; negative: before it.
  double depthOf(const Vector3& ball) const { return ball.x() - home_.x() + kRadius - kFace; }

 private:
  static constexpr double kFace = 0.05;       // from home [m]
  static constexpr double kRadius = 0.01;     // of the ball [m]
  static constexpr double kStiffness = 2000;  // [N/m]

  Vector3 home_;
  double handStiffness_;
  HapticScene scene_;
};

}  // namespace haptiv::test
