#include "app/commands/device/DeviceListCommand.h"

#include <algorithm>
#include <iostream>
#include <memory>

#include "app/commands/ExitCode.h"
#include "app/commands/Report.h"
#include "app/commands/device/DeviceTable.h"
#include "device/described/DeviceDescription.h"
#include "device/descriptions/BuiltInDescriptions.h"
#include "device/usb/PluggedDevices.h"

namespace haptiv {
namespace {

struct DeviceListOptions {
  std::string firmware;  // of a Falcon; empty: where it is looked for
  bool json = false;
};

Report::List listOf(const std::vector<PluggedDevice>& devices, PluggedKind kind) {
  Report::List list;
  for (const PluggedDevice& device : devices) {
    if (device.kind != kind) continue;
    Report& entry = list.emplace_back();
    entry.add("name", device.name());
    entry.add("serial", device.serial);
    entry.add("port", device.port);
    entry.add("product", device.product);
    entry.add("bus", static_cast<std::uint64_t>(device.bus));
    entry.add("address", static_cast<std::uint64_t>(device.address));
    entry.add("high_speed", device.highSpeed);
    entry.add("state", nameOf(device.state));
    entry.add("trouble", device.trouble);
  }
  return list;
}

void printTable(const std::vector<PluggedDevice>& devices) {
  printDevices(std::cout, devices);
  std::cout << "descriptions built in\n";
  for (const BuiltInDescription& builtIn : builtInDescriptions()) {
    const std::string name(builtIn.name);
    std::cout << "  " << name << std::string(20 - std::min<std::size_t>(19, name.size()), ' ')
              << loadDeviceDescription(name).jointCount() << " joints\n";
  }
  std::cout << std::flush;
}

int listDevices(const DeviceListOptions& options) {
  const std::vector<PluggedDevice> devices = pluggedDevices(options.firmware);
  if (!options.json) {
    printTable(devices);
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
  for (const PluggedKind kind : {PluggedKind::board, PluggedKind::falcon, PluggedKind::spaceMouse})
    report.add(keywordOf(kind), listOf(devices, kind));
  report.add("descriptions", descriptions);
  report.print(true);
  return kGood;
}

}  // namespace

void addDeviceListCommand(const Command& device) {
  const auto options = std::make_shared<DeviceListOptions>();
  const Command list = device.add("list", "What is plugged in and whether it can be used; built-in descriptions",
                                  [options] { return listDevices(*options); });
  list.path("--firmware", options->firmware,
            "The Falcon's firmware, to see whether it can be one; without this, ~/.local/share/haptiv/falcon.bin")
      .type("FILE");
  list.json(options->json);
}

}  // namespace haptiv
