#include "app/commands/device/DeviceCalibrateCommand.h"

#include <memory>

#include "app/calibration/CalibrationGuide.h"
#include "app/calibration/LoadsFile.h"
#include "app/commands/NamedFile.h"
#include "app/commands/Report.h"
#include "app/commands/device/CalibrationRun.h"

namespace haptiv {
namespace {

struct CalibrateOptions : CalibrationOptions {
  std::string loads;  // a file, or "standard"; empty: bias alone
};

Report::Numbers numbersOf(const Vector6& v, int from) {
  return {v.data() + from, v.data() + from + 3};
}

void addAxes(Report& report, const std::string& name, const Vector6& value) {
  report.add(name + "_N", numbersOf(value, 0));
  report.add(name + "_Nm", numbersOf(value, 3));
}

std::vector<KnownLoad> loadsOf(const CalibrateOptions& options) {
  if (options.loads.empty()) return {};
  if (options.loads != "standard") return readLoadsFile(options.loads);
  std::vector<KnownLoad> loads;
  for (const Vector6& load : standardLoads()) loads.push_back({load, {}});
  return loads;
}

SensorBias findBias(const CalibrateOptions& options, BrakedDevice& device, Calibration& calibration) {
  askOperator(device, "Take the hand off the handle and leave it alone.");
  return judged([&] { return calibration.takeBias(measure(device, options)); });
}

void hang(const CalibrateOptions& options, BrakedDevice& device, const KnownLoad& known, const std::string& which,
          Calibration& calibration) {
  if (known.counts) return calibration.takeLoad(known.load, *known.counts);
  askOperator(device,
              which + ": hang on " + loadInWords(known.load) + ", in the handle's axes, and let it hang still.");
  if (LoadedHandle* handle = device.handle()) {
    handle->hang(known.load);
    device.measure(BrakedDevice::kSettle);
  }
  judged([&] {
    calibration.takeLoad(known.load, measure(device, options));
    return 0;
  });
}

SensorMatrix findMatrix(const CalibrateOptions& options, BrakedDevice& device, const std::vector<KnownLoad>& loads,
                        Calibration& calibration) {
  for (std::size_t i = 0; i < loads.size(); ++i) {
    hang(options, device, loads[i], "Load " + std::to_string(i + 1) + " of " + std::to_string(loads.size()),
         calibration);
  }
  return judged([&] { return calibration.takeMatrix(); });
}

void add(Report& report, const SensorMatrix& found, std::size_t loads) {
  report.add("loads", static_cast<std::uint64_t>(loads));
  report.add("condition", found.condition);
  addAxes(report, "residual", found.residual);
  Report::Rows rows;
  for (int i = 0; i < 6; ++i) {
    const Vector6 row = found.matrix.row(i);
    rows.emplace_back(row.data(), row.data() + 6);
  }
  report.add("matrix", rows);
}

int calibrate(const CalibrateOptions& options) {
  const DeviceDescription description = loadDeviceDescription(options.description);
  if (description.type == DeviceType::impedance)
    throw CommandFailure(kWrongUsage, description.name + ": has no force sensor, so there is nothing to calibrate");
  const std::vector<KnownLoad> loads = loadsOf(options);
  if (!options.out.empty()) requireWritable(options.out);
  BrakedDevice device = calibrationDevice(options, description);
  Calibration calibration(description);
  const SensorBias bias = findBias(options, device, calibration);

  Report report;
  report.add("description", description.name);
  addAxes(report, "bias", bias.bias);
  addAxes(report, "deviation", bias.deviation);
  if (!loads.empty()) add(report, findMatrix(options, device, loads, calibration), loads.size());
  writeDescription(options, calibration);
  if (!options.out.empty()) report.add("out", options.out);
  report.print(options.json);
  return kGood;
}

}  // namespace

void addDeviceCalibrateCommand(const Command& device) {
  const auto options = std::make_shared<CalibrateOptions>();
  const Command calibrate = device.add("calibrate", "Find bias and matrix of the handle's sensor, step by step",
                                       [options] { return haptiv::calibrate(*options); });
  addCalibrationOptions(calibrate, *options);
  calibrate
      .path("--loads", options->loads,
            "Known loads for the matrix: a CSV file with the columns fx,fy,fz,tx,ty,tz in N and N m, or standard; "
            "without this, the bias alone")
      .type("FILE.csv");
}

}  // namespace haptiv
