#pragma once

#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// Keeps the scene's force from stepping when the scene is edited, and at the start of a session.
///
/// What an edit would have stepped by is withheld at first, and let through over kDuration.
struct SceneFade {
  static constexpr double kDuration = 0.1;  ///< [s]

  bool started = false;
  std::uint32_t sceneVersion = 0;
  Vector3 felt = Vector3::Zero();  ///< of the tick before, in W [N]; zero before the first one
  Vector3 bump = Vector3::Zero();  ///< what is withheld in whole, in W [N] ...
  double left = 0;                 ///< ... and how much of it still is, 1 to 0

  /// @param raw  force of the scene as it is now, in W [N]
  /// @return     the force to be felt, in W [N]
  /// Realtime-safe: yes.
  Vector3 apply(const HapticScene& scene, const Vector3& raw, double period) noexcept;
};

}  // namespace haptiv
