#include "app/commands/study/KinematicsCommand.h"

#include <Eigen/SVD>
#include <charconv>
#include <cmath>
#include <memory>

#include "app/commands/ExitCode.h"
#include "app/commands/Report.h"
#include "device/described/DeviceDescription.h"
#include "device/kinematics/ArmKinematics.h"
#include "device/redundancy/criterion/Criterion.h"

namespace haptiv {
namespace {

struct KinematicsOptions {
  std::string q;  // joint angles [rad] with commas between
  std::string description = "vishard10";
  bool json = false;
};

JointVector parseAngles(const std::string& text, int joints) {
  const std::string all = std::to_string(joints);
  const auto refuse = [&](const std::string& why) {
    throw CommandFailure(kWrongUsage, "--q " + text + ": " + why + "; give " + all +
                                          " joint angles in rad with commas between, no blanks");
  };
  JointVector q = JointVector::Zero();
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int joint = 0; joint < joints; ++joint) {
    const std::string which = "angle " + std::to_string(joint + 1);
    if (joint > 0 && (at == end || *at++ != ',')) refuse("there are only " + std::to_string(joint) + " angles");
    const auto [rest, error] = std::from_chars(at, end, q[joint]);
    if (error != std::errc() || !std::isfinite(q[joint])) refuse(which + " is no number");
    if (rest != end && *rest != ',') refuse(which + " is no number");
    at = rest;
  }
  if (at != end) refuse("there are more than " + all + " angles");
  return q;
}

template <typename Derived>
Report::Rows rowsOf(const Eigen::MatrixBase<Derived>& matrix) {
  Report::Rows rows;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    Report::Numbers& entries = rows.emplace_back();
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) entries.push_back(matrix(row, column));
  }
  return rows;
}

/// Falling.
template <int Rows>
Report::Numbers singularValues(const Eigen::Matrix<double, Rows, kJointCount>& J) {
  const auto sigma = Eigen::JacobiSVD<Eigen::Matrix<double, Rows, kJointCount>>(J).singularValues();
  return {sigma.data(), sigma.data() + sigma.size()};
}

/// m = V / kappa, all rate weights one                                          [paper, eq. (14)]
double dexterity(const Report::Numbers& sigma) {
  return directionalManipulability(Vector3(sigma[0], sigma[1], sigma[2]));
}

int describePose(const KinematicsOptions& options) {
  const ArmKinematics arm(loadDeviceDescription(options.description));
  const JointVector q = parseAngles(options.q, arm.jointCount());
  const Pose pose = arm.forward(q);
  const Jacobian J = arm.jacobian(q);
  const Report::Numbers translational = singularValues<3>(J.topRows<3>());
  const Report::Numbers rotational = singularValues<3>(J.bottomRows<3>());

  Report report;
  report.add("position_m", numbers(pose.position));
  report.add("rotation", rowsOf(pose.rotation));
  report.add("jacobian", rowsOf(J.leftCols(arm.jointCount())));
  report.add("singular_values", singularValues<6>(J));
  report.add("singular_values_trans", translational);
  report.add("singular_values_rot", rotational);
  report.add("sigma_min_rot", rotational.back());
  report.add("index_trans", dexterity(translational));
  report.add("index_rot", dexterity(rotational));
  report.print(options.json);
  return kGood;
}

}  // namespace

void addKinematicsCommand(const Command& program) {
  const auto options = std::make_shared<KinematicsOptions>();
  const Command kinematics =
      program.add("kinematics", "Pose, Jacobian and dexterity of an arm", [options] { return describePose(*options); });
  kinematics.text("--q", options->q, "Joint angles in rad, with commas between").type("Q1,...,Q10").required();
  kinematics.path("--description", options->description, "The arm: a built-in name, or a device description (.toml)")
      .type("NAME|FILE")
      .showDefault();
  kinematics.json(options->json);
}

}  // namespace haptiv
