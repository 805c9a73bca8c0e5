#pragma once

#include <cstdint>
#include <optional>

#include "device/types.h"
#include "device/usb/spacemouse/SpaceMouseState.h"

namespace haptiv {

/// A SpaceMouse as the operator's hand: its cap moves and turns the place where the hand wants the handle.
///
/// Button 1 is the dead-man, and with it the hand's grip: while it is held the hand holds the handle, from where it
/// then is. Button 2 is the reset. A cap that is let go of, within its dead band, moves nothing at all: there is no
/// drift. The hand never wants to be farther than kLeash from the ball, so that it pushes no harder the longer a wall
/// holds it. Unplugged, or silent with a cap that stood aside, it has let go. Thread: any one.
class SpaceMouseHand {
 public:
  enum class Mode : std::uint8_t {
    velocity,  ///< as far as the cap is pushed, so fast the hand moves
    position,  ///< as far as the cap is pushed, so far the hand is from where it took hold
  };
  static constexpr double kSpeed = 0.2;       ///< of a cap that is pushed all the way [m/s]
  static constexpr double kTurningSpeed = 1;  ///< [rad/s]
  static constexpr double kReach = 0.1;       ///< the same by position [m]
  static constexpr double kTurn = 0.8;        ///< [rad]
  static constexpr double kLeash = 0.15;      ///< [m]
  static constexpr double kFull = 350;        ///< counts of a cap that is pushed all the way
  static constexpr double kDeadBand = 20;     ///< counts
  static constexpr double kSilence = 0.25;    ///< a cap that stands aside tells so each 8 ms; gone after [s]
  static constexpr std::uint32_t kHold = 1u << 0, kReset = 1u << 1;  ///< buttons

  explicit SpaceMouseHand(Mode mode = Mode::velocity) : mode_(mode) {}

  /// What the hand wants.
  struct Wish {
    std::optional<Vector3> place;            ///< p_WH [m]; nothing: it has let go, and the dead-man with it
    Matrix3 rotation = Matrix3::Identity();  ///< R_WH, where it holds
    std::uint16_t inputs = 0;                ///< OperatorInput bits beside the dead-man
  };

  /// @param now      monotonic, as the state's [ns]
  /// @param X_WT     the handle now
  /// @param heading  of the one who looks at the scene, about z: 0 looks along y [rad]
  Wish follow(const SpaceMouseState& state, std::int64_t now, const Pose& X_WT, double heading = 0);

 private:
  Mode mode_;
  bool holds_ = false;
  std::int64_t before_ = 0;  // [ns]
  Pose taken_;               // X_WT when the hand took hold
  Pose wanted_;              // X_WH
};

}  // namespace haptiv
