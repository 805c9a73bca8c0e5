#pragma once

#include <optional>

#include "device/safety/SafetySignals.h"
#include "device/types.h"

namespace haptiv {

/// What the operator does: where the hand wants the handle to be, and what is pressed.
struct HandTarget {
  bool holding = false;                  ///< false: the hand has let go, no force
  Vector3 position = Vector3::Zero();    ///< p_BH [m]
  std::uint16_t inputs = kInputDeadMan;  ///< OperatorInput bits
  std::optional<Matrix3> orientation{};  ///< R_BH; nothing: as the handle stood when the hand took hold of it
  Wrench load{};                         ///< on the handle besides what the hand does, in T; of weights, say
};

/// Says what the hand wants at each tick. Implementations: ScriptedHand, LiveHand.
class HandSource {
 public:
  virtual ~HandSource() = default;
  /// @param time  since the device started [s]; never decreasing
  /// Realtime-safe: yes.  Thread: servo.
  virtual HandTarget at(double time) noexcept = 0;
};

}  // namespace haptiv
