#include "device/redundancy/ToolDisplacement.h"

#include <Eigen/Geometry>
#include <cmath>

namespace haptiv {
namespace {

struct SineCosine {
  double sine;
  double cosine;
};

/// Taylor series, to rounding, for what a joint turns in a tick.
SineCosine ofSmall(double angle) noexcept {
  if (std::abs(angle) > 0.01) return {std::sin(angle), std::cos(angle)};
  const double square = angle * angle;
  return {angle * (1 - square * (1. / 6 - square * (1. / 120))),
          1 - square * (1. / 2 - square * (1. / 24 - square * (1. / 720)))};
}

}  // namespace

Vector6 toolDisplacement(const Jacobian& J, const JointVector& step) noexcept {
  Vector3 x = Vector3::Zero();  // the tool's place, from where it was
  // Unit quaternion of the tool's turn; its scalar part follows from the vector part.
  double scalar = 1;
  Vector3 vector = Vector3::Zero();
  for (int i = kJointCount - 1; i >= 0; --i) {
    const Vector3 w = J.col(i).tail<3>();
    const auto [sine, cosine] = ofSmall(step[i] / 2);
    const Vector3 velocity = J.col(i).head<3>() + w.cross(x);  // of a point at x, per rate of the joint
    x += 2 * sine * (cosine * velocity + sine * w.cross(velocity));
    const Vector3 turned = sine * (scalar * w + w.cross(vector)) + cosine * vector;
    scalar = cosine * scalar - sine * w.dot(vector);
    vector = turned;
  }
  Vector6 displacement;
  displacement << x, 2 * (1 + vector.squaredNorm() / 6) * vector;  // 2 asin |vector|, to third order
  return displacement;
}

}  // namespace haptiv
