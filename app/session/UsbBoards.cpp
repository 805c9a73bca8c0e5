#include "app/session/UsbBoards.h"

#include <string_view>

namespace haptiv {
namespace {

constexpr std::string_view kWithSerial = "usb:";

}  // namespace

bool isBoard(const std::string& device) {
  return device == "usb" || device.starts_with(kWithSerial);
}

std::string boardSerialOf(const std::string& device) {
  return device.starts_with(kWithSerial) ? device.substr(kWithSerial.size()) : std::string();
}

std::function<std::unique_ptr<HapticDevice>()> boardOf(const std::string& device,
                                                       const DeviceDescription& description) {
  return [choice = UsbDeviceChoice{boardSerialOf(device), std::nullopt, false}, description] {
    return std::make_unique<UsbDevice>(description, choice);
  };
}

}  // namespace haptiv
