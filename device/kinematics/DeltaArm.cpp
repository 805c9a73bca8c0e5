#include "device/kinematics/DeltaArm.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace haptiv {
namespace {

constexpr double kClosed = 1e-15;       // [m^2]: 10 fm of a forearm
constexpr double kLongestMove = 0.03;   // [m]
constexpr double kMiddlingAngle = 0.6;  // [rad]
constexpr double kThere = 1e-7;         // [m]; near a singular pose h's roundings count by their roots
constexpr double kSingular = 1e-9;      // of the determinant, relative

/// Whether three rows hold a handle: their determinant against their lengths.
bool holds(const Matrix3& rows) noexcept {
  const double volume = rows.row(0).norm() * rows.row(1).norm() * rows.row(2).norm();
  return std::abs(rows.determinant()) > kSingular * volume;
}

}  // namespace

DeltaArm::DeltaArm(const DeltaGeometry& geometry) : geometry_(geometry) {
  for (int i = 0; i < kLegs; ++i) {
    const double angle = geometry.legAngles[i];
    legs_[static_cast<std::size_t>(i)] = {{std::cos(angle), std::sin(angle), 0},
                                          {-std::sin(angle), std::cos(angle), 0}};
  }
  middle_ = firstGuess(JointVector::Constant(kMiddlingAngle));
}

DeltaArm::Closure DeltaArm::close(const Leg& leg, const Vector3& p_BT, double angle) const noexcept {
  const DeltaGeometry& g = geometry_;
  const double reachU = g.upperArm * std::cos(angle), reachW = g.upperArm * std::sin(angle);
  const double du = leg.u.dot(p_BT) - g.baseRadius + g.platformRadius - reachU;
  const double dv = leg.v.dot(p_BT) - g.baseOffset;
  const double dw = p_BT.z() - reachW;
  const double across = std::hypot(du, dw);
  const double bar = across - g.hinges;
  const double slope = across > 0 ? 2 * bar / across : 0;
  return {bar * bar + dv * dv - g.forearm * g.forearm, slope * (du * leg.u + dw * Vector3::UnitZ()) + 2 * dv * leg.v,
          slope * (du * reachW - dw * reachU)};
}

Vector3 DeltaArm::gaps(const Vector3& p_BT, const JointVector& q, Matrix3& byPlace) const noexcept {
  Vector3 gaps;
  for (int i = 0; i < kLegs; ++i) {
    const Closure closure = close(legs_[static_cast<std::size_t>(i)], p_BT, q[i]);
    gaps[i] = closure.gap;
    byPlace.row(i) = closure.byPlace;
  }
  return gaps;
}

/// Exact where the three angles are the same: the handle is on B's z axis then.
Vector3 DeltaArm::firstGuess(const JointVector& q) const noexcept {
  const DeltaGeometry& g = geometry_;
  const double mean = q.head<kLegs>().mean();
  const double across = g.hinges + std::sqrt(std::max(g.forearm * g.forearm - g.baseOffset * g.baseOffset, 0.));
  const double du = g.platformRadius - g.baseRadius - g.upperArm * std::cos(mean);
  return {0, 0, g.upperArm * std::sin(mean) + std::sqrt(std::max(across * across - du * du, 0.))};
}

Pose DeltaArm::forward(const JointVector& q) const noexcept {
  Vector3 best = firstGuess(q);
  Matrix3 byPlace;
  Vector3 open = gaps(best, q, byPlace);
  double share = 1;
  for (int i = 0; i < kMostSteps && open.norm() > kClosed && holds(byPlace); ++i) {
    Vector3 step = -share * (byPlace.inverse() * open);
    step *= kLongestMove / std::max(step.norm(), kLongestMove);
    Matrix3 byPlaceThere;
    const Vector3 openThere = gaps(best + step, q, byPlaceThere);
    if (!(openThere.norm() < open.norm())) {  // too far, or the legs do not meet: shorter steps
      share /= 4;
      continue;
    }
    best += step;
    open = openThere;
    byPlace = byPlaceThere;
    share = std::min(2 * share, 1.);
  }
  return {best, Matrix3::Identity()};
}

ArmPose DeltaArm::evaluate(const JointVector& q) const noexcept {
  ArmPose arm{forward(q), Jacobian::Zero()};
  Matrix3 byPlace;
  Vector3 byAngle;
  for (int i = 0; i < kLegs; ++i) {
    const Closure closure = close(legs_[static_cast<std::size_t>(i)], arm.X_BT.position, q[i]);
    byPlace.row(i) = closure.byPlace;
    byAngle[i] = closure.byAngle;
  }
  if (holds(byPlace)) arm.J_BT.topLeftCorner<3, kLegs>() = -byPlace.inverse() * byAngle.asDiagonal();
  return arm;
}

bool DeltaArm::solve(const Leg& leg, const Vector3& p_BT, double& angle) const noexcept {
  const DeltaGeometry& g = geometry_;
  const double u = leg.u.dot(p_BT) - g.baseRadius + g.platformRadius;
  const double v = leg.v.dot(p_BT) - g.baseOffset;
  const double along = g.forearm * g.forearm - v * v;
  const double distance = std::hypot(u, p_BT.z());
  if (!(along >= 0) || !(distance > 0)) return false;
  // The upper arm and what of the forearm lies in its plane, as two sides of a triangle.
  const double across = g.hinges + std::sqrt(along);
  const double cosine = (g.upperArm * g.upperArm + distance * distance - across * across) / (2 * g.upperArm * distance);
  if (!(std::abs(cosine) <= 1)) return false;
  angle = std::atan2(p_BT.z(), u) - std::acos(cosine);
  return true;
}

bool DeltaArm::solve(const Vector3& p_BT, JointVector& q) const noexcept {
  q.setZero();
  for (int i = 0; i < kLegs; ++i) {
    if (!solve(legs_[static_cast<std::size_t>(i)], p_BT, q[i])) return false;
  }
  return true;
}

bool DeltaArm::reaches(const Vector3& p_BT) const noexcept {
  JointVector q;
  return p_BT.z() > 0 && solve(p_BT, q) && (forward(q).position - p_BT).norm() <= kThere;
}

JointVector DeltaArm::inverse(const Vector3& p_BT) const noexcept {
  constexpr int kHalvings = 50;
  double in = reaches(p_BT) ? 1 : 0, out = 1;
  for (int i = 0; in < 1 && i < kHalvings; ++i) {
    const double between = (in + out) / 2;
    (reaches(middle_ + between * (p_BT - middle_)) ? in : out) = between;
  }
  const Vector3 place = in < 1 ? Vector3(middle_ + in * (p_BT - middle_)) : p_BT;
  JointVector q;
  solve(place, q);
  return q;
}

ArmSkeleton DeltaArm::skeleton(const JointVector& q) const noexcept {
  const DeltaGeometry& g = geometry_;
  const Vector3 handle = forward(q).position;
  std::array<std::array<Vector3, 3>, kLegs> legs;  // base, elbow, end of the forearm
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Leg& leg = legs_[i];
    const double angle = q[static_cast<Eigen::Index>(i)];
    const Vector3 base = g.baseRadius * leg.u + g.baseOffset * leg.v;
    const Vector3 elbow = base + g.upperArm * (std::cos(angle) * leg.u + std::sin(angle) * Vector3::UnitZ());
    legs[i] = {base, elbow, handle + g.platformRadius * leg.u};
  }
  const auto& [first, second, third] = legs;
  ArmSkeleton skeleton;
  for (const Vector3& place :
       {first[0], first[1], first[2], handle, second[2], second[1], second[0], third[0], third[1], third[2], handle})
    skeleton.at[static_cast<std::size_t>(skeleton.count++)] = place;
  return skeleton;
}

}  // namespace haptiv
