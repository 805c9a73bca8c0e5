#include "app/commands/device/DeviceListCommand.h"

#include <algorithm>
#include <iostream>
#include <memory>

#include "app/commands/ExitCode.h"
#include "app/commands/Report.h"
#include "device/DeviceDescription.h"
#include "device/descriptions/BuiltInDescriptions.h"

namespace haptiv {
namespace {

struct DeviceListOptions {
  bool json = false;
};

constexpr const char* kUsb = "none: this version drives no USB device";

void printTable() {
  std::cout << "devices\n  sim                 the simulated arm, of any description\n  usb                 " << kUsb
            << "\ndescriptions built in\n";
  for (const BuiltInDescription& builtIn : builtInDescriptions()) {
    const std::string name(builtIn.name);
    std::cout << "  " << name << std::string(20 - std::min<std::size_t>(19, name.size()), ' ')
              << loadDeviceDescription(name).jointCount() << " joints\n";
  }
  std::cout << std::flush;
}

int listDevices(const DeviceListOptions& options) {
  if (!options.json) {
    printTable();
    if (!std::cout) throw CommandFailure(kCouldNot, "standard output cannot be written");
    return kGood;
  }
  Report::List descriptions;
  for (const BuiltInDescription& builtIn : builtInDescriptions()) {
    Report& entry = descriptions.emplace_back();
    entry.add("name", std::string(builtIn.name));
    entry.add("joints", static_cast<std::uint64_t>(loadDeviceDescription(std::string(builtIn.name)).jointCount()));
  }
  Report report;
  report.add("devices", Report::Names{"sim"});
  report.add("usb", kUsb);
  report.add("descriptions", descriptions);
  report.print(true);
  return kGood;
}

}  // namespace

void addDeviceListCommand(const Command& device) {
  const auto options = std::make_shared<DeviceListOptions>();
  const Command list = device.add("list", "What there is: devices and built-in descriptions",
                                  [options] { return listDevices(*options); });
  list.json(options->json);
}

}  // namespace haptiv
