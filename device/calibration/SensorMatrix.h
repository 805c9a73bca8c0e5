#pragma once

#include <span>

#include "device/calibration/Samples.h"

namespace haptiv {

/// A known load at the handle and what the sensor said of it.
struct LoadCase {
  Vector6 load = Vector6::Zero();  ///< force and torque on the handle, in T [N], [N m]
  Vector6 raw = Vector6::Zero();   ///< mean of HandleSensor::raw [N], [N m]
};

/// A sensor's matrix as loads tell it.
struct SensorMatrix {
  Matrix6 matrix = Matrix6::Identity();
  double condition = 0;                ///< of the loads: how well they tell the axes apart; 1 is best
  Vector6 residual = Vector6::Zero();  ///< root mean square of what the matrix leaves unexplained [N], [N m]
};

inline constexpr std::size_t kFewestLoads = 7;     ///< one more than unknowns in a row, so that residuals say something
inline constexpr double kWorstLoads = 50;          ///< condition
inline constexpr double kWorstResidual = 0.02;     ///< of an axis' largest load
inline constexpr double kWorstSensorMatrix = 100;  ///< condition, of a description that is accepted

/// The matrix that makes of the sensor's readings the loads, by least squares:
///   minimise sum |matrix (raw - bias) - load|^2, every axis in parts of its range
/// Throws CalibrationRefused where there are fewer loads than kFewestLoads, or they leave an axis open (kWorstLoads),
/// or the matrix does not explain them (kWorstResidual), or it were none that a description may have.
SensorMatrix findMatrix(std::span<const LoadCase> cases, const Vector6& bias, const HandleSensor& sensor);

/// How badly the sensor's matrix is conditioned, every axis in parts of its range; infinite where it is singular.
double sensorMatrixCondition(const HandleSensor& sensor);

}  // namespace haptiv
