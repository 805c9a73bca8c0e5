#include "app/commands/device/DeviceListCommand.h"

#include <algorithm>
#include <iostream>
#include <memory>

#include "app/commands/ExitCode.h"
#include "app/commands/Report.h"
#include "device/DeviceDescription.h"
#include "device/descriptions/BuiltInDescriptions.h"
#include "device/usb/host/BoardList.h"

namespace haptiv {
namespace {

struct DeviceListOptions {
  bool json = false;
};

/// One line a board; what to give --device first.
void printBoards(const std::vector<usb::ListedBoard>& boards) {
  if (boards.empty()) std::cout << "  usb                 no interface board is plugged in\n";
  for (const usb::ListedBoard& board : boards) {
    std::cout << "  usb:" << board.serial << std::string(16 - std::min<std::size_t>(15, board.serial.size()), ' ')
              << board.product << ", bus " << board.bus << ", device " << board.address
              << (board.highSpeed ? ", high speed" : ", full speed") << "\n";
    if (!board.trouble.empty()) std::cout << "                      " << board.trouble << "\n";
  }
}

Report::List listOf(const std::vector<usb::ListedBoard>& boards) {
  Report::List list;
  for (const usb::ListedBoard& board : boards) {
    Report& entry = list.emplace_back();
    entry.add("serial", board.serial);
    entry.add("product", board.product);
    entry.add("bus", static_cast<std::uint64_t>(board.bus));
    entry.add("address", static_cast<std::uint64_t>(board.address));
    entry.add("high_speed", board.highSpeed);
    entry.add("trouble", board.trouble);
  }
  return list;
}

void printTable(const std::vector<usb::ListedBoard>& boards) {
  std::cout << "devices\n  sim                 the simulated arm, of any description\n";
  printBoards(boards);
  std::cout << "descriptions built in\n";
  for (const BuiltInDescription& builtIn : builtInDescriptions()) {
    const std::string name(builtIn.name);
    std::cout << "  " << name << std::string(20 - std::min<std::size_t>(19, name.size()), ' ')
              << loadDeviceDescription(name).jointCount() << " joints\n";
  }
  std::cout << std::flush;
}

int listDevices(const DeviceListOptions& options) {
  const std::vector<usb::ListedBoard> boards = usb::listBoards();
  if (!options.json) {
    printTable(boards);
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
  report.add("usb", listOf(boards));
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
