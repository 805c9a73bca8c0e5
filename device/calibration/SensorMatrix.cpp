#include "device/calibration/SensorMatrix.h"

#include <Eigen/SVD>
#include <cmath>
#include <limits>
#include <sstream>

#include "device/calibration/QuietCheck.h"

namespace haptiv {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 6>;

double conditionOf(const Eigen::VectorXd& singularValues) {
  const double smallest = singularValues[singularValues.size() - 1];
  return smallest > 0 ? singularValues[0] / smallest : std::numeric_limits<double>::infinity();
}

/// A row a load, every axis in parts of its range.
Rows scaled(std::span<const LoadCase> cases, Vector6 LoadCase::*which, const Vector6& less, const Vector6& range) {
  Rows rows(static_cast<Eigen::Index>(cases.size()), 6);
  for (std::size_t i = 0; i < cases.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) = (cases[i].*which - less).cwiseQuotient(range);
  return rows;
}

void expectDistinct(double condition, const Vector6& weakest) {
  if (condition <= kWorstLoads) return;
  Eigen::Index axis = 0;
  weakest.cwiseAbs().maxCoeff(&axis);
  std::ostringstream message;
  message.precision(3);
  message << "the loads tell the axes badly apart: condition " << condition << ", at most " << kWorstLoads
          << "; add loads with more " << nameOfAxis(static_cast<int>(axis)) << ", both ways";
  throw CalibrationRefused(message.str());
}

void expectExplained(const Vector6& residual, const Rows& loads) {
  for (int i = 0; i < 6; ++i) {
    const double largest = loads.col(i).cwiseAbs().maxCoeff();
    if (residual[i] <= kWorstResidual * largest) continue;
    std::ostringstream message;
    message.precision(2);
    message << "no matrix explains the loads: " << nameOfAxis(i) << " is off by " << 100 * residual[i] / largest
            << " % of its largest load; see that the bias has been taken and that every load hangs as its line says, "
               "and measure again";
    throw CalibrationRefused(message.str());
  }
}

}  // namespace

SensorMatrix findMatrix(std::span<const LoadCase> cases, const Vector6& bias, const HandleSensor& sensor) {
  if (cases.size() < kFewestLoads)
    throw CalibrationRefused(std::to_string(cases.size()) + " loads are too few; give " + std::to_string(kFewestLoads) +
                             " or more, each axis both ways");
  const Vector6 range = sensor.range();
  const Rows said = scaled(cases, &LoadCase::raw, bias, range);
  const Rows loads = scaled(cases, &LoadCase::load, Vector6::Zero(), range);
  if (!said.allFinite() || !loads.allFinite())
    throw CalibrationRefused("a load or reading is no finite number; correct it");
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(said, Eigen::ComputeThinU | Eigen::ComputeThinV);
  SensorMatrix found;
  found.condition = conditionOf(svd.singularValues());
  expectDistinct(found.condition, svd.matrixV().col(5));
  const Matrix6 inParts = svd.solve(loads).transpose();
  const Vector6 residual =
      ((said * inParts.transpose() - loads).colwise().squaredNorm() / static_cast<double>(cases.size()))
          .cwiseSqrt()
          .transpose();
  expectExplained(residual, loads);
  found.matrix = range.asDiagonal() * inParts * range.cwiseInverse().asDiagonal();
  found.residual = residual.cwiseProduct(range);
  HandleSensor with = sensor;
  with.matrix = found.matrix;
  if (!(sensorMatrixCondition(with) <= kWorstSensorMatrix))
    throw CalibrationRefused(
        "the loads give a matrix that confuses the axes; check the loads' signs and units (N, N m)");
  return found;
}

double sensorMatrixCondition(const HandleSensor& sensor) {
  const Vector6 range = sensor.range();
  const Matrix6 inParts = range.cwiseInverse().asDiagonal() * sensor.matrix * range.asDiagonal();
  return conditionOf(Eigen::JacobiSVD<Matrix6>(inParts).singularValues());
}

}  // namespace haptiv
