#include "device/redundancy/criterion/JacobianDerivative.h"

namespace haptiv {

Jacobian jacobianDerivative(const Jacobian& J, int k) noexcept {
  const auto v = J.topRows<3>();
  const auto w = J.bottomRows<3>();
  Jacobian derivative = Jacobian::Zero();
  for (int i = 0; i < kJointCount; ++i) {
    derivative.col(i).head<3>() = k <= i ? w.col(k).cross(v.col(i)) : w.col(i).cross(v.col(k));
    if (k < i) derivative.col(i).tail<3>() = w.col(k).cross(w.col(i));
  }
  return derivative;
}

Vector6 toolAcceleration(const Jacobian& J, const JointVector& rates) noexcept {
  Vector3 linear = Vector3::Zero(), angular = Vector3::Zero();
  Vector3 turning = Vector3::Zero();          // of link i: sum of w_k qdot_k over k <= i
  Vector3 velocity = J.topRows<3>() * rates;  // that joints i.. give the tool: sum of v_k qdot_k over k >= i
  for (int i = 0; i < kJointCount; ++i) {
    const Vector3 v = rates[i] * J.col(i).head<3>();
    const Vector3 w = rates[i] * J.col(i).tail<3>();
    angular += turning.cross(w);
    turning += w;
    velocity -= v;
    linear += turning.cross(v) + w.cross(velocity);
  }
  Vector6 acceleration;
  acceleration << linear, angular;
  return acceleration;
}

JointVector gradientByLinearRows(const Jacobian& J, const JacobianBlock& P) noexcept {
  JointVector gradient;
  Vector3 before = Vector3::Zero();  // sum of P_i x w_i over i < k
  for (int k = 0; k < kJointCount; ++k) {
    gradient[k] = J.col(k).head<3>().dot(before);
    before += P.col(k).cross(J.col(k).tail<3>());
  }
  Vector3 from = Vector3::Zero();  // sum of v_i x P_i over i >= k
  for (int k = kJointCount - 1; k >= 0; --k) {
    from += J.col(k).head<3>().cross(P.col(k));
    gradient[k] += J.col(k).tail<3>().dot(from);
  }
  return gradient;
}

}  // namespace haptiv
