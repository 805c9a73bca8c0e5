#include "app/commands/device/DeviceHomeCommand.h"

#include <memory>
#include <sstream>

#include "app/commands/NamedFile.h"
#include "app/commands/Report.h"
#include "app/commands/device/CalibrationRun.h"

namespace haptiv {
namespace {

struct HomeOptions : CalibrationOptions {
  bool anew = false;
};

std::string words(const JointVector& angles, int joints) {
  std::ostringstream text;
  text.precision(5);
  for (int i = 0; i < joints; ++i) text << (i == 0 ? "" : ", ") << angles[i];
  return text.str();
}

/// What the arm's encoders are at the reference pose becomes the description's zero.
FoundZero findZero(const HomeOptions& options, BrakedDevice& device, Calibration& calibration) {
  const DeviceDescription& description = calibration.description();
  askOperator(device, "Set the arm by hand into its reference pose, joint angles " +
                          words(description.encoders.reference, description.jointCount()) + " rad, and let go.");
  return judged([&] {
    if (device.isLost()) device.findAgain(measure(device, options), description);
    return calibration.takeZero(measure(device, options), options.anew);
  });
}

Report::Numbers numbersOf(const JointVector& values, int joints) {
  return {values.data(), values.data() + joints};
}

int home(const HomeOptions& options) {
  const DeviceDescription description = loadDeviceDescription(options.description);
  if (!options.out.empty()) requireWritable(options.out);
  BrakedDevice device = calibrationDevice(options, description);
  Calibration calibration(description);
  const FoundZero found = findZero(options, device, calibration);
  // Without a file, the description stays as it is and the encoders are told what it says of this pose.
  const DeviceDescription& valid = options.out.empty() ? description : calibration.description();
  Homing* homing = device.homing();
  if (options.out.empty() && homing == nullptr)
    throw CommandFailure(kWrongUsage,
                         "this device's encoders cannot be told their zero; give --out FILE.toml, so that "
                         "the description has it");
  if (homing != nullptr) homing->home(valid.countsAt(valid.encoders.reference));
  writeDescription(options, calibration);

  Report report;
  report.add("description", description.name);
  report.add("reference_rad", numbersOf(description.encoders.reference, description.jointCount()));
  report.add("change_rad", numbersOf(found.change, description.jointCount()));
  report.add("zero_counts", numbersOf(valid.encoders.zero, description.jointCount()));
  report.add("homed", homing != nullptr && homing->homed());
  if (!options.out.empty()) report.add("out", options.out);
  report.print(options.json);
  return kGood;
}

}  // namespace

void addDeviceHomeCommand(const Command& device) {
  const auto options = std::make_shared<HomeOptions>();
  const Command home = device.add("home", "Give the encoders a zero, at the arm's reference pose",
                                  [options] { return haptiv::home(*options); });
  addCalibrationOptions(home, *options);
  home.flag("--anew", options->anew, "No zero was known, or power was lost: take any counts for the reference pose");
}

}  // namespace haptiv
