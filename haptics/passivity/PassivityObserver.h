#pragma once

#include "device/types.h"

namespace haptiv {

/// What the operator's hand and the tool do at a tick, in W.
struct HandMeetsTool {
  Vector3 handForce = Vector3::Zero();     ///< of the hand on the tool, measured [N]
  Vector3 tool = Vector3::Zero();          ///< p_WT, measured [m]
  Vector3 ball = Vector3::Zero();          ///< of the virtual mass, which the tool follows [m]
  Vector3 ballVelocity = Vector3::Zero();  ///< [m/s]
};

/// Time-domain passivity observer: counts the energy that flows into the display, tick by tick, without a model of
/// device or hand (Hannaford and Ryu). Below zero, the display has given more than it has taken.
///
/// It begins with kReserve, and keeps no more than that and what the scene can give back: what was dissipated must not
/// pay for what is given later. So whatever happened before, the display gives at most kReserve while the energy stays
/// above zero.
struct PassivityObserver {
  static constexpr double kReserve = 1e-3;  ///< [J]: 2 kg at 0.03 m/s

  double energy = kReserve;  ///< [J]

  /// Causality of an admittance: force in, motion out. All that is not the hand and not the virtual mass is counted:
  /// scene, free motion, limiters, controller, and the arm, which follows late.
  ///
  ///   E += f_h . v dt - d(m v^2 / 2) - e . df_h          v, e: means over the tick; e = tool - ball
  /// The first two are exact for the steps of the virtual mass. The last is the work f_h . de of the hand on the arm's
  /// lag, without what f_h . e gives back: a constant force on a constant lag does nothing.
  /// Realtime-safe: yes.
  void seeMass(const HandMeetsTool& now, double mass, double period) noexcept;

  /// Causality of an impedance: motion in, force out.  E -= f . d(tool), f: the display's force over the tick.
  /// Realtime-safe: yes.
  void seeTool(const HandMeetsTool& now) noexcept;

  /// The force on the ball until the next tick, in W [N].
  void hold(const Vector3& force) noexcept { heldForce = force; }

  /// Forgets what is more than kReserve and `stored`, which the scene's springs hold [J]. Realtime-safe: yes.
  void forgetSurplus(double stored) noexcept;

  bool started = false;
  HandMeetsTool last;
  Vector3 heldForce = Vector3::Zero();
};

}  // namespace haptiv
