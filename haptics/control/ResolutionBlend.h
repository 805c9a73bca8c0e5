#pragma once

#include "device/redundancy/RedundancyResolution.h"

namespace haptiv {

/// Keeps joint rates from stepping when the operator chooses another resolution, and at the start of a session: over
/// kDuration the rates go from those of one choice to those of the next. Both move the tool as wanted; so does every
/// mean of them. A choice that comes meanwhile waits for its turn.
struct ResolutionBlend {
  static constexpr double kDuration = 0.5;  ///< [s]

  ResolutionChoice from, to;
  double share = 1;  ///< of `to`

  /// As RedundancyResolution::rates. Realtime-safe: yes.
  JointVector rates(const RedundancyResolution& resolution, const ResolutionChoice& wanted, const JointVector& q,
                    const Jacobian& J, const Vector6& twist, double period) noexcept;
};

}  // namespace haptiv
