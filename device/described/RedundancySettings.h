#pragma once

#include <vector>

#include "device/control/ResolutionChoice.h"
#include "device/types.h"

namespace haptiv {

/// Step length lambda of eq. (16) for each side criterion [rad^2/s]: rates of self-motion per gradient of the weighted
/// sum of normalised criteria, eq. (15).
struct StepLengths {
  double man = 1;
  double dir = 1;
  double cond = 1;
};

/// How an arm's redundancy is resolved; docs/redundancy.md tells how the numbers of a description are found.
struct RedundancySettings {
  ResolutionChoice choice;  ///< where the operator has not chosen
  StepLengths stepFull;
  StepLengths stepPartitioned;
  double translationWeight = 1;  ///< w1 of eq. (15), of the translational criterion
  double rotationWeight = 1;     ///< w2, of the rotational one
  /// Weighs joints by their rate limits, eqs. (7), (8), the fastest by one; otherwise all weigh the same.
  bool weighByRateLimits = false;
  /// The normalisation of eq. (15) is the average, over these poses [rad], of the best value that self-motion reaches
  /// from there. Without any, the arm's home is the pose.
  std::vector<JointVector> normalisationPoses;
};

}  // namespace haptiv
