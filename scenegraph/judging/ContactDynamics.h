#pragma once

namespace haptiv {

/// A mass at a spring and a damper: the tool against a wall, or in a zone. The paper's section V-C, and its sampled
/// form.
struct ContactDynamics {
  double mass = 2;       ///< m [kg]
  double stiffness = 0;  ///< k [N/m]
  double damping = 0;    ///< b [N s/m]

  /// omega_0 = sqrt(k / m) [rad/s]                                                              [paper, eq. (31)]
  double naturalFrequency() const;
  /// d = b / (2 m sqrt(k / m)); infinite without stiffness, none without damping                 [paper, eq. (32)]
  double dampingRatio() const;
  /// k_opt = b^2 / 2m: with it d = sqrt(2)/2, and the shortest transient [N/m]                   [paper, eq. (33)]
  double optimalStiffness() const;
  /// b = sqrt(2 m k): the damping for which the stiffness is the optimal one, (33) turned round [N s/m]
  double optimalDamping() const;

  /// What of the sampled bound is used up: k dt^2 / m + 2 b dt / m < 4 is stable, and at 1 this is all of it.
  ///
  /// The admittance steps v' = v - (k x + b v) dt / m, x' = x + v' dt: the force of a tick is that of its beginning.
  /// With s = k dt^2 / m and r = b dt / m that is a linear map of trace 2 - s - r and determinant 1 - r, whose
  /// eigenvalues lie within the unit circle (Jury) if and only if s > 0, r > 0 and s + 2 r < 4. A wall damps on the way
  /// in alone: where the way in is stable, the way out (r = 0) is, and so are all sequences of the two that have been
  /// tried; beyond s + r = 4, a step in and a step out together grow.
  double usedOfSampledBound(double period) const;
  /// The largest stiffness within that bound, 4 m / dt^2 - 2 b / dt; negative: the damping alone is too much [N/m].
  double largestSampledStiffness(double period) const;
};

}  // namespace haptiv
