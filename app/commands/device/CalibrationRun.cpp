#include "app/commands/device/CalibrationRun.h"

#include <cmath>
#include <iostream>

#include "app/commands/DeviceName.h"
#include "app/commands/WholeFile.h"
#include "app/session/Falcons.h"
#include "app/session/UsbBoards.h"

namespace haptiv {

BrakedDevice calibrationDevice(const CalibrationOptions& options, const DeviceDescription& description) {
  refuseWithoutName(options.device);
  if (options.device == "sim" || isBoard(options.device))
    return BrakedDevice::named(options.device, description, static_cast<std::uint64_t>(options.seed));
  if (isFalcon(options.device))
    throw CommandFailure(kWrongUsage, "--device " + options.device +
                                          ": a Falcon has no force sensor, and it is homed whenever a session starts; "
                                          "there is nothing to do");
  throw CommandFailure(kWrongUsage, "--device " + options.device +
                                        ": there is no such device; use sim, usb or "
                                        "usb:WHICH, as haptiv device list names them");
}

void askOperator(const BrakedDevice& device, const std::string& what) {
  std::cerr << what << (device.isSimulated() ? "\n" : " Then press Enter. ") << std::flush;
  if (device.isSimulated()) return;
  if (std::string line; !std::getline(std::cin, line))
    throw CommandFailure(kCouldNot, "nobody is there to press Enter; run this in a terminal");
}

QuietMeasurement measure(BrakedDevice& device, const CalibrationOptions& options) {
  return device.measure(std::llround(options.seconds / BrakedDevice::kPeriod));
}

void addCalibrationOptions(const Command& command, CalibrationOptions& options) {
  command.path("DESCRIPTION", options.description, "Of the device: a built-in name, or a file (.toml)").showDefault();
  command
      .text("--device", options.device,
            "The device: sim, an arm that is not quite as described; usb (usb:WHICH), an interface board")
      .type("NAME")
      .showDefault();
  command.path("--out", options.out, "Write the description here, with what was found; comments and all else stay")
      .type("FILE.toml");
  command.number("--seconds", options.seconds, {0.4, 600}, "How long each measurement takes").type("S").showDefault();
  command.count("--seed", options.seed, {0, 1e9}, "Of what is wrong with the simulated arm").type("N").showDefault();
  command.json(options.json);
}

void writeDescription(const CalibrationOptions& options, const Calibration& calibration) {
  if (options.out.empty()) return;
  writeWholly(options.out, calibration.text(options.description));
}

}  // namespace haptiv
