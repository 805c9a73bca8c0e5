#pragma once

#include <vector>

#include "app/experiments/RunSetup.h"
#include "device/types.h"

namespace haptiv {

/// The arm at one moment of a run. Indices are m = V / kappa, eq. (14), with equal weights of the joints.
struct RunSample {
  double time = 0;        ///< [s]
  JointVector q;          ///< [rad]
  JointVector rates;      ///< [rad/s]
  Vector3 sigmaTrans;     ///< singular values of J's rows 0..2, falling [m]
  Vector3 sigmaRot;       ///< of rows 3..5, falling [1]
  double indexTrans = 0;  ///< [m^3]
  double indexRot = 0;
  double conditionTrans = 1;
  double conditionRot = 1;
  double positionError = 0;     ///< from the wanted place [m]
  double orientationError = 0;  ///< from the wanted orientation [rad]
};

/// What a run came to, over all of its ticks.
struct RunSummary {
  double meanIndexTrans = 0;  ///< [m^3]
  double meanIndexRot = 0;
  double leastIndexRot = 0;
  double greatestIndexRot = 0;
  double leastSigmaRot = 0;      ///< smallest rotational singular value
  double leastSigmaRotTime = 0;  ///< when [s]
  double greatestConditionRot = 0;
  double meanConditionTrans = 0;
  double meanConditionRot = 0;
  double greatestPositionError = 0;     ///< [m]
  double greatestOrientationError = 0;  ///< [rad]
  double greatestRate = 0;              ///< of any joint [rad/s]
  double greatestRateShare = 0;         ///< of its limit
  double selfMotionVelocity = 0;        ///< of the tool by the null-space part of the rates, |J_v qdot_h| [m/s]
  double selfMotionStep = 0;            ///< the tool's place after a tick with self-motion, from that without [m]
  double rateBeyondBounds = 0;      ///< by how much self-motion drives a joint beyond its limit, eqs. (17)-(20) [rad/s]
  double heldRateBeyondBounds = 0;  ///< the same of rates that are corrected for being held for a tick [rad/s]
  double startBend7 = 0;            ///< |th7| of links 6 and 7, from 0, stretched, to pi, folded, at the start [rad]
  double leastBend7 = 0;            ///< the least
  bool finite = true;               ///< never NaN or infinite
};

struct RunResult {
  RunSetup setup;
  std::vector<RunSample> samples;  ///< every kSampleTicks ticks, and the last
  RunSummary summary;
};

}  // namespace haptiv
