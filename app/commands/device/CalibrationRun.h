#pragma once

#include <cstdint>
#include <string>

#include "app/calibration/BrakedDevice.h"
#include "app/calibration/Calibration.h"
#include "app/commands/Command.h"
#include "app/commands/ExitCode.h"
#include "device/calibration/CalibrationRefused.h"

/// What `haptiv device calibrate` and `haptiv device home` share.
namespace haptiv {

struct CalibrationOptions {
  std::string description = "vishard10";
  std::string device = "sim";
  std::string out;     // empty: nothing is written
  double seconds = 2;  // of a measurement
  int seed = 1;        // of the simulated arm's faults
  bool json = false;
};

/// The device by its name on the command line. Throws CommandFailure where there is none.
BrakedDevice calibrationDevice(const CalibrationOptions& options, const DeviceDescription& description);

/// Tells the operator what to do, and waits for the Enter key where there is one to do it: a simulated arm needs none.
/// Throws CommandFailure where nobody can press it.
void askOperator(const BrakedDevice& device, const std::string& what);

/// As long as asked for.
QuietMeasurement measure(BrakedDevice& device, const CalibrationOptions& options);

/// Writes the calibrated description, if a file is asked for. Throws CommandFailure where it cannot.
void writeDescription(const CalibrationOptions& options, const Calibration& calibration);

/// The options that both commands have.
void addCalibrationOptions(const Command& command, CalibrationOptions& options);

/// Does a step; where it refuses what was measured, the command ends with exit code 1.
template <typename Step>
auto judged(const Step& step) {
  try {
    return step();
  } catch (const CalibrationRefused& refused) {
    throw CommandFailure(kNotSo, refused.what());
  }
}

}  // namespace haptiv
