#include "device/redundancy/Normalisation.h"

#include <cmath>

#include "device/kinematics/ArmKinematics.h"
#include "device/redundancy/DriftCorrection.h"
#include "device/redundancy/FullSolution.h"
#include "device/redundancy/PartitionedSolution.h"

namespace haptiv {
namespace {

constexpr int kMostSteps = 100;
constexpr double kFirstStep = 0.1, kLongestStep = 0.4, kShortestStep = 1e-3;  // of the fastest joint [rad]
constexpr double kLeastGain = 1e-4;                                           // of a step, in parts of the value

/// Drives one criterion of an arm that holds its tool still to its best.
class Climb {
 public:
  Climb(const ArmKinematics& arm, const DeviceDescription& description, const ResolutionChoice& choice,
        const JointVector& squaredWeights)
      : arm_(arm), description_(description), choice_(choice), squaredWeights_(squaredWeights) {}

  /// @param which  one for the criterion to be driven, zero for the other
  double best(const JointVector& start, const CriterionPair& which) const;

 private:
  /// Calls `use` with the solution at q.
  template <typename Use>
  auto at(const JointVector& q, const Jacobian& J, const Use& use) const {
    if (choice_.solution == Solution::full) return use(FullSolution(J, squaredWeights_, description_.control));
    return use(PartitionedSolution(q, J, squaredWeights_, description_.control));
  }
  double value(const JointVector& q, const CriterionPair& which) const;
  JointVector direction(const JointVector& q, const CriterionPair& which) const;
  JointVector hold(JointVector q, const Pose& X_BT) const;

  const ArmKinematics& arm_;
  const DeviceDescription& description_;
  ResolutionChoice choice_;
  JointVector squaredWeights_;
};

double Climb::value(const JointVector& q, const CriterionPair& which) const {
  const CriterionPair values =
      at(q, arm_.jacobian(q), [&](const auto& solution) { return solution.values(choice_.strategy); });
  return which.translation * values.translation + which.rotation * values.rotation;
}

JointVector Climb::direction(const JointVector& q, const CriterionPair& which) const {
  const double sign = choice_.strategy == Strategy::cond ? -1 : 1;
  const Jacobian J = arm_.jacobian(q);
  return at(q, J, [&](const auto& solution) {
    return solution.selfMotion(choice_.strategy, {sign * which.translation, sign * which.rotation});
  });
}

/// Newton steps back to where the tool was.
JointVector Climb::hold(JointVector q, const Pose& X_BT) const {
  for (int i = 0; i < 2; ++i) {
    const ArmPose pose = arm_.evaluate(q);
    const Vector6 drift = driftCorrection(X_BT, pose.X_BT, 1);
    q += at(q, pose.J_BT, [&](const auto& solution) { return solution.leastNorm(drift); });
  }
  return q;
}

double Climb::best(const JointVector& start, const CriterionPair& which) const {
  const Pose X_BT = arm_.forward(start);
  const double sign = choice_.strategy == Strategy::cond ? -1 : 1;
  JointVector q = start;
  double best = value(q, which);
  double length = kFirstStep;
  JointVector along = direction(q, which);
  for (int i = 0; i < kMostSteps && length >= kShortestStep; ++i) {
    const double fastest = along.cwiseAbs().maxCoeff();
    if (!(fastest > 0) || !std::isfinite(fastest)) break;
    const JointVector next = hold(q + length / fastest * along, X_BT);
    const double there = value(next, which);
    if (!(sign * there > sign * best)) {
      length /= 3;
      continue;
    }
    const bool isThere = std::abs(there - best) < kLeastGain * std::abs(best);
    q = next;
    best = there;
    if (isThere) break;
    along = direction(q, which);
    length = std::min(1.5 * length, kLongestStep);
  }
  return best;
}

}  // namespace

CriterionPair normalisation(const DeviceDescription& description, const ResolutionChoice& choice,
                            const JointVector& squaredWeights) {
  if (choice.strategy == Strategy::nonopt) return {1, 1};
  std::vector<JointVector> poses = description.redundancy.normalisationPoses;
  if (poses.empty()) poses = {description.homeAngles};
  const ArmKinematics arm(description);
  const Climb climb(arm, description, choice, squaredWeights);
  CriterionPair sum;
  for (const JointVector& pose : poses) {
    sum.translation += climb.best(pose, {1, 0});
    sum.rotation += climb.best(pose, {0, 1});
  }
  const auto average = [&](double total) {
    const double mean = total / static_cast<double>(poses.size());
    return std::isfinite(mean) && mean > 1e-12 ? mean : 1;
  };
  return {average(sum.translation), average(sum.rotation)};
}

}  // namespace haptiv
