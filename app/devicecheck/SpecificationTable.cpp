#include "app/devicecheck/SpecificationTable.h"

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "device/kinematics/ArmKinematics.h"

namespace haptiv {
namespace {

constexpr double kMeeting = 1e-6;    // [m] from a point to the axes that meet in it
constexpr double kAtShoulder = 0.1;  // [m]

/// Where the axes of the first three joints meet, in B; nothing where they do not, or are parallel.
std::optional<Vector3> shoulderOf(const DeviceDescription& device) {
  if (device.chain.joints.size() < 3) return std::nullopt;
  const SerialChain chain(device.chain);
  const ArmSkeleton skeleton = chain.skeleton(device.homeAngles);
  const ArmPose arm = chain.evaluate(device.homeAngles);
  Matrix3 sum = Matrix3::Zero();
  Vector3 right = Vector3::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vector3 axis = arm.J_BT.col(i).tail<3>();
    const Matrix3 across = Matrix3::Identity() - axis * axis.transpose();
    sum += across;
    right += across * skeleton.at[i];
  }
  const Eigen::FullPivLU<Matrix3> solver(sum);
  if (solver.rank() < 3) return std::nullopt;
  const Vector3 meeting = solver.solve(right);
  for (int i = 0; i < 3; ++i) {
    const Vector3 axis = arm.J_BT.col(i).tail<3>();
    if (axis.cross(meeting - skeleton.at[i]).norm() > kMeeting) return std::nullopt;
  }
  return meeting;
}

using Value = std::function<double(const TourSample&)>;

SpecificationRow rowOf(const Tour& tour, const char* property, bool atLeast, double limit, const Value& value) {
  SpecificationRow row{property, atLeast, limit, value(tour.samples.front()), tour.samples.front(), {}};
  for (const TourSample& sample : tour.samples) {
    const double candidate = value(sample);
    const bool worse = atLeast ? candidate < row.worst : candidate > row.worst;
    if (!worse && !std::isnan(candidate)) continue;  // what is no number is as bad as can be
    row.worst = candidate;
    row.where = sample;
  }
  return row;
}

}  // namespace

std::vector<SpecificationRow> judge(const Tour& tour, const Specification& wanted, const DeviceDescription& device) {
  const auto least = [&tour](const char* property, double limit, double PoseFigures::*figure) {
    return rowOf(tour, property, true, limit, [figure](const TourSample& sample) { return sample.figures.*figure; });
  };
  const auto most = [&tour](const char* property, double limit, double TourSample::*error) {
    return rowOf(tour, property, false, limit, [error](const TourSample& sample) { return sample.*error; });
  };
  std::vector<SpecificationRow> rows = {
      most("place_error_m", wanted.placeError, &TourSample::placeError),
      most("turn_error_rad", wanted.turnError, &TourSample::turnError),
      least("sigma_min_trans_m", wanted.smallestTranslation, &PoseFigures::sigmaTranslation),
      least("sigma_min_rot", wanted.smallestRotation, &PoseFigures::sigmaRotation),
      least("manipulability_m3", device.control.singularityThreshold, &PoseFigures::manipulability),
      least("force_N", wanted.force, &PoseFigures::force),
      least("pitch_yaw_torque_Nm", wanted.pitchYawTorque, &PoseFigures::pitchYawTorque),
      least("roll_torque_Nm", wanted.rollTorque, &PoseFigures::rollTorque),
      least("speed_m_per_s", wanted.speed, &PoseFigures::speed),
  };
  const auto shoulder = shoulderOf(device);
  for (SpecificationRow& row : rows) {
    if (row.holds() || !shoulder) continue;
    const double away = (row.where.position - *shoulder).norm();
    if (away < kAtShoulder && row.where.figures.sigmaTranslation < wanted.smallestTranslation)
      row.remark = "interior singularity at the shoulder, where the axes of joints 1, 2 and 3 meet";
  }
  return rows;
}

}  // namespace haptiv
