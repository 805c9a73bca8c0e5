#include "app/commands/device/DeviceTable.h"

#include <algorithm>
#include <array>
#include <string>

namespace haptiv {
namespace {

using Row = std::array<std::string, 5>;
using Widths = std::array<std::size_t, 5>;

/// In words; what to do about it stands in a line of its own.
std::string stateOf(const PluggedDevice& device) {
  return nameOf(device.state) +
         std::string(device.highSpeed || device.kind != PluggedKind::board ? "" : ", full speed");
}

Row rowOf(const PluggedDevice& device) {
  const auto orNone = [](const std::string& text) { return text.empty() ? "-" : text; };
  return {device.name(), device.product, orNone(device.serial), device.port, stateOf(device)};
}

/// The widest entry of each column but the last, which may run on.
Widths widthsOf(const std::vector<Row>& rows) {
  Widths widths{};
  for (const Row& row : rows)
    for (std::size_t i = 0; i + 1 < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  return widths;
}

void printRow(std::ostream& out, const Row& row, const Widths& widths) {
  out << " ";
  for (std::size_t i = 0; i < row.size(); ++i) {
    out << " " << row[i];
    if (i + 1 < row.size()) out << std::string(widths[i] + 1 - row[i].size(), ' ');
  }
  out << "\n";
}

constexpr const char* kNothingThere =
    "  no interface board, Falcon or SpaceMouse is plugged in. Plug one in and switch it on; where lsusb shows it and\n"
    "  this does not, it is of a kind that is not known here: docs/usb.md, docs/falcon.md, docs/spacemouse.md\n";

}  // namespace

void printDevices(std::ostream& out, const std::vector<PluggedDevice>& devices) {
  std::vector<Row> rows = {{"name", "what", "serial number", "port", "state"},
                           {"sim", "simulated arm", "-", "-", "usable"}};
  for (const PluggedDevice& device : devices) rows.push_back(rowOf(device));
  const Widths widths = widthsOf(rows);
  out << "devices: give the name to --device, a SpaceMouse's to --hand\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    printRow(out, rows[i], widths);
    if (i >= 2 && !devices[i - 2].trouble.empty()) out << "      " << devices[i - 2].trouble << "\n";
  }
  if (devices.empty()) out << kNothingThere;
}

}  // namespace haptiv
