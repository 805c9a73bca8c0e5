#include "app/session/hands/SpaceMouseHand.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "device/safety/SafetySignals.h"

namespace haptiv {
namespace {

constexpr double kLongestStep = 0.1;  // [s]; a program that was away for longer does not catch up

/// -1 to 1; zero within the dead band, and without a step at its edge.
double share(std::int16_t counts) {
  const double beyond = std::abs(static_cast<double>(counts)) - SpaceMouseHand::kDeadBand;
  return std::copysign(std::clamp(beyond / (SpaceMouseHand::kFull - SpaceMouseHand::kDeadBand), 0., 1.), counts);
}

/// The cap's axes are right, towards the user, down; those of W, seen by one who looks along y, right, away, up.
Vector3 inScene(const SpaceMouseState& state, std::size_t first, double heading) {
  const Vector3 seen(share(state.axes[first]), -share(state.axes[first + 1]), -share(state.axes[first + 2]));
  return Eigen::AngleAxisd(heading, Vector3::UnitZ()) * seen;
}

Matrix3 turnedBy(const Vector3& turn, const Matrix3& rotation) {
  const double angle = turn.norm();
  if (angle == 0) return rotation;
  const Eigen::Quaterniond both =
      Eigen::Quaterniond(Eigen::AngleAxisd(angle, turn / angle)) * Eigen::Quaterniond(rotation);
  return both.normalized().toRotationMatrix();
}

Vector3 noFartherThan(double most, const Vector3& from, const Vector3& place) {
  const Vector3 way = place - from;
  const double length = way.norm();
  return length > most ? Vector3(from + way * (most / length)) : place;
}

}  // namespace

SpaceMouseHand::Wish SpaceMouseHand::follow(const SpaceMouseState& state, std::int64_t now, const Pose& X_WT,
                                            double heading) {
  const double step = std::clamp(1e-9 * static_cast<double>(now - before_), 0., kLongestStep);
  before_ = now;
  const Vector3 push = inScene(state, 0, heading), turn = inScene(state, 3, heading);
  const bool aside = !push.isZero(0) || !turn.isZero(0);
  const bool silent = aside && 1e-9 * static_cast<double>(now - state.time) > kSilence;
  Wish wish;
  if (state.connected && (state.buttons & kReset) != 0) wish.inputs = kInputReset;
  if (!state.connected || silent || (state.buttons & kHold) == 0) {
    holds_ = false;
    return wish;
  }
  if (!holds_) taken_ = wanted_ = X_WT;
  if (mode_ == Mode::position) {
    wanted_ = {taken_.position + kReach * push, turnedBy(kTurn * turn, taken_.rotation)};
  } else if (holds_) {
    wanted_ = {wanted_.position + step * kSpeed * push, turnedBy(step * kTurningSpeed * turn, wanted_.rotation)};
  }
  holds_ = true;
  if (aside) wanted_.position = noFartherThan(kLeash, X_WT.position, wanted_.position);
  wish.place = wanted_.position;
  wish.rotation = wanted_.rotation;
  return wish;
}

}  // namespace haptiv
