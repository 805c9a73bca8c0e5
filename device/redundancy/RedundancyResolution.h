#pragma once

#include "device/DeviceDescription.h"
#include "device/redundancy/ResolutionChoice.h"
#include "device/types.h"

namespace haptiv {

/// Turns a twist of the tool into joint rates, and uses the arm's self-motion for dexterity:
/// qdot = J# xdot + lambda (I - J# J) grad H, eqs. (4), (5), (16), for all joints at once, or, eqs. (24), (25), for
/// position and orientation apart. H is the weighted sum of normalised criteria, eq. (15), of the description.
class RedundancyResolution {
 public:
  /// Computes the normalisations of all criteria, of both solutions: some milliseconds, so that any choice is ready.
  explicit RedundancyResolution(const DeviceDescription& description);

  /// Joint rates [rad/s] that move the tool as wanted.
  ///
  /// Self-motion never drives a joint beyond its rate limit: lambda is shortened as eqs. (17)-(20) ask. The rest can:
  /// the joint limiter slows that.
  /// An arm that is no VISHARD10 has no partitioned solution: the full one serves.
  ///
  /// @param q       [rad]
  /// @param J       J_BT at q
  /// @param twist   wanted, of the tool, in B [m/s, rad/s], drift correction included
  /// @param period  for which the rates are held [s]
  /// Realtime-safe: yes.  Input that is not finite gives zero rates.
  JointVector rates(const ResolutionChoice& choice, const JointVector& q, const Jacobian& J, const Vector6& twist,
                    double period) const noexcept;

 private:
  RedundancySettings settings_;
  ControlSettings control_;
};

}  // namespace haptiv
