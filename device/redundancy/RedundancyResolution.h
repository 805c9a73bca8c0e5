#pragma once

#include <array>

#include "device/control/ResolutionNames.h"
#include "device/described/DeviceDescription.h"
#include "device/redundancy/criterion/CriterionPair.h"
#include "device/types.h"

namespace haptiv {

/// Turns a twist of the tool into joint rates, and uses the arm's self-motion for dexterity:
/// qdot = J# xdot + lambda (I - J# J) grad H, eqs. (4), (5), (16), for all joints at once, or, eqs. (24), (25), for
/// position and orientation apart. H is the weighted sum of normalised criteria, eq. (15), of the description.
class RedundancyResolution {
 public:
  /// Computes the normalisations of all criteria, of both solutions: some milliseconds, so that any choice is ready.
  /// Throws std::invalid_argument where the description's chain is none; a parsed description's never is.
  explicit RedundancyResolution(const DeviceDescription& description);

  /// Joint rates [rad/s] that move the tool as wanted.
  ///
  /// Self-motion never drives a joint beyond its rate limit: lambda is shortened as eqs. (17)-(20) ask. The rest can:
  /// the joint limiter slows that.
  /// Rates held for a period move the tool along a curve; that is taken out to second order, so that self-motion
  /// leaves the tool still, and not only its velocity zero. With a period of zero it is not.
  /// An arm that is no VISHARD10 has no partitioned solution: the full one serves.
  ///
  /// @param q       [rad]
  /// @param J       J_BT at q
  /// @param twist   wanted, of the tool, in B [m/s, rad/s], drift correction included
  /// @param period  for which the rates are held [s]
  /// Realtime-safe: yes.  Input that is not finite gives zero rates.
  JointVector rates(const ResolutionChoice& choice, const JointVector& q, const Jacobian& J, const Vector6& twist,
                    double period) const noexcept;

  /// Whether the arm has a partitioned solution.
  bool isPartitionable() const noexcept { return isPartitionable_; }
  /// By what a choice's criteria are divided, eq. (15). Realtime-safe: yes.
  const CriterionPair& normalisationOf(const ResolutionChoice& choice) const noexcept {
    return prepared(choice).normalisation;
  }

 private:
  /// What is ready for each choice.
  struct Prepared {
    double step = 0;  ///< lambda
    CriterionPair normalisation;
    CriterionPair weights;  ///< of the criteria as they are: weight over normalisation, signed to be maximised
  };

  const Prepared& prepared(const ResolutionChoice& choice) const noexcept;
  Prepared prepare(const DeviceDescription& description, const ResolutionChoice& choice) const;
  template <typename At>
  JointVector compose(const At& solution, Strategy strategy, const Prepared& prepared, const Jacobian& J,
                      const Vector6& twist, double period) const noexcept;

  ControlSettings control_;
  JointVector rateLimit_;
  JointVector squaredWeights_;
  bool isPartitionable_;
  std::array<std::array<Prepared, kStrategies.size()>, kSolutions.size()> prepared_;
};

}  // namespace haptiv
