#include "app/experiments/Simulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "device/kinematics/Vishard10.h"
#include "device/redundancy/DriftCorrection.h"
#include "device/redundancy/criterion/Criterion.h"

namespace haptiv {
namespace {

/// The wanted motion at t: straight to where the path is a tick later.
Vector6 wantedTwist(const CircularPath& path, double t, const Pose& X_BT, double driftGain) {
  const Pose wanted = path.at(t);
  Vector6 twist = driftCorrection(wanted, X_BT, driftGain);
  twist.head<3>() += (path.at(t + kTick).position - wanted.position) / kTick;
  return twist;
}

RunSample sampleOf(double t, const JointVector& q, const JointVector& rates, const Jacobian& J, const Pose& wanted,
                   const Pose& X_BT) {
  const Dexterity translational = translationalDexterity(J);
  const Dexterity rotational = rotationalDexterity(J);
  const Vector6 error = driftCorrection(wanted, X_BT, 1);
  return {.time = t,
          .q = q,
          .rates = rates,
          .sigmaTrans = translational.sigma,
          .sigmaRot = rotational.sigma,
          .indexTrans = translational.directional(),
          .indexRot = rotational.directional(),
          .conditionTrans = translational.condition(),
          .conditionRot = rotational.condition(),
          .positionError = error.head<3>().norm(),
          .orientationError = error.tail<3>().norm()};
}

/// Gathers a run's summary tick by tick.
class Summing {
 public:
  explicit Summing(const JointVector& rateLimit) : rateLimit_(rateLimit) {}

  void add(const RunSample& now) {
    const double bend7 = std::abs(std::remainder(now.q[6], 2 * std::numbers::pi));
    if (ticks_++ == 0) {
      sum_.leastIndexRot = sum_.leastSigmaRot = HUGE_VAL;
      sum_.startBend7 = sum_.leastBend7 = bend7;
    }
    if (now.sigmaRot[2] < sum_.leastSigmaRot) {
      sum_.leastSigmaRot = now.sigmaRot[2];
      sum_.leastSigmaRotTime = now.time;
    }
    sum_.meanIndexTrans += now.indexTrans;
    sum_.meanIndexRot += now.indexRot;
    sum_.meanConditionTrans += now.conditionTrans;
    sum_.meanConditionRot += now.conditionRot;
    sum_.leastIndexRot = std::min(sum_.leastIndexRot, now.indexRot);
    sum_.greatestIndexRot = std::max(sum_.greatestIndexRot, now.indexRot);
    sum_.greatestPositionError = std::max(sum_.greatestPositionError, now.positionError);
    sum_.greatestOrientationError = std::max(sum_.greatestOrientationError, now.orientationError);
    sum_.greatestRate = std::max(sum_.greatestRate, now.rates.cwiseAbs().maxCoeff());
    sum_.greatestRateShare =
        std::max(sum_.greatestRateShare, now.rates.cwiseAbs().cwiseQuotient(rateLimit_).maxCoeff());
    sum_.leastBend7 = std::min(sum_.leastBend7, bend7);
    sum_.finite = sum_.finite && now.q.allFinite() && now.rates.allFinite() && std::isfinite(now.positionError);
  }

  /// What self-motion does: the tick's rates against those of least norm, and both without the correction for the
  /// tick's length, whose difference is the null-space part alone.
  void addSelfMotion(const Vishard10& arm, const RedundancyResolution& resolution, const ResolutionChoice& choice,
                     const JointVector& q, const Jacobian& J, const Vector6& twist, const JointVector& rates) {
    const ResolutionChoice leastNorm{Strategy::nonopt, choice.solution};
    const JointVector without = resolution.rates(leastNorm, q, J, twist, kTick);
    const Vector3 step = arm.forward(q + kTick * rates).position - arm.forward(q + kTick * without).position;
    sum_.selfMotionStep = std::max(sum_.selfMotionStep, step.norm());
    sum_.heldRateBeyondBounds = std::max(sum_.heldRateBeyondBounds, beyondBounds(rates, without));

    const JointVector momentary = resolution.rates(choice, q, J, twist, 0);
    const JointVector momentaryWithout = resolution.rates(leastNorm, q, J, twist, 0);
    const double velocity = (J.topRows<3>() * (momentary - momentaryWithout)).norm();
    sum_.selfMotionVelocity = std::max(sum_.selfMotionVelocity, velocity);
    sum_.rateBeyondBounds = std::max(sum_.rateBeyondBounds, beyondBounds(momentary, momentaryWithout));
  }

  RunSummary result() const {
    RunSummary summary = sum_;
    for (double* mean :
         {&summary.meanIndexTrans, &summary.meanIndexRot, &summary.meanConditionTrans, &summary.meanConditionRot})
      *mean /= std::max(1, ticks_);
    return summary;
  }

 private:
  /// By how much a joint exceeds its limit, or what it does without self-motion where that is more [rad/s].
  double beyondBounds(const JointVector& rates, const JointVector& without) const {
    return (rates.cwiseAbs() - rateLimit_.cwiseMax(without.cwiseAbs())).maxCoeff();
  }

  JointVector rateLimit_;
  RunSummary sum_;
  int ticks_ = 0;
};

}  // namespace

RunResult simulate(const RunSetup& setup, const DeviceDescription& device, const RedundancyResolution& resolution) {
  const Vishard10 arm(device.links);
  const auto ticks = static_cast<int>(std::lround(setup.duration / kTick));
  Summing summing(device.drives.rateLimit);
  RunResult result{setup, {}, {}};
  result.samples.reserve(static_cast<std::size_t>(ticks / kSampleTicks + 2));

  JointVector q = setup.startAngles;
  for (int tick = 0; tick <= ticks; ++tick) {
    const double t = tick * kTick;
    const Pose X_BT = arm.forward(q);
    const Jacobian J = arm.jacobian(q);
    const Vector6 twist = wantedTwist(setup.path, t, X_BT, device.control.driftGain);
    const JointVector rates = resolution.rates(setup.choice, q, J, twist, kTick);
    const RunSample sample = sampleOf(t, q, rates, J, setup.path.at(t), X_BT);
    summing.add(sample);
    if (setup.choice.strategy != Strategy::nonopt)
      summing.addSelfMotion(arm, resolution, setup.choice, q, J, twist, rates);
    if (tick % kSampleTicks == 0 || tick == ticks) result.samples.push_back(sample);
    q += kTick * rates;
  }
  result.summary = summing.result();
  return result;
}

}  // namespace haptiv
