#include "device/usb/PluggedDevices.h"

#include <array>

#include "device/usb/falcon/FalconFirmware.h"
#include "device/usb/falcon/FalconPort.h"
#include "device/usb/host/BoardRequests.h"
#include "device/usb/libusb/UsbTrial.h"
#include "device/usb/spacemouse/SpaceMouseModels.h"

namespace haptiv {
namespace {

PluggedState stateOf(usb::UsbTrouble trouble) {
  if (trouble == usb::UsbTrouble::noPermission) return PluggedState::noPermission;
  return trouble == usb::UsbTrouble::busy ? PluggedState::held : PluggedState::unusable;
}

void judge(PluggedDevice& device, const std::optional<usb::UsbFailure>& failure) {
  if (!failure) return;
  device.state = stateOf(failure->trouble());
  device.trouble = failure->what();
}

/// Nobody holds it: who is it?
void askBoard(PluggedDevice& device, const usb::FoundUsb& found) {
  try {
    usb::UsbHandle board(found, usb::boardKind());
    if (usb::askIdentity(board).homed) return;
    device.state = PluggedState::notHomed;
    device.trouble = "its encoders do not know the arm's pose: haptiv device home --device " + device.name();
  } catch (const usb::UsbFailure& failure) {
    judge(device, failure);
  }
}

void lookForFirmware(PluggedDevice& device, const std::string& path) {
  try {
    falcon::readFirmware(path.empty() ? falcon::firmwarePath() : path);
  } catch (const std::exception& error) {
    device.state = PluggedState::firmwareMissing;
    device.trouble = error.what();
  }
}

std::string productOf(PluggedKind kind, const usb::FoundUsb& found) {
  const SpaceMouseModel* model = spaceMouseModel(found.id.vendor, found.id.product);
  if (kind == PluggedKind::spaceMouse && model != nullptr) return std::string(model->name);
  return found.product.empty() ? nameOf(kind) : found.product;
}

usb::UsbKind usbKindOf(PluggedKind kind) {
  if (kind == PluggedKind::board) return usb::boardKind();
  return kind == PluggedKind::falcon ? falcon::usbKind() : spaceMouseKind();
}

void add(std::vector<PluggedDevice>& list, const usb::UsbContext& context, PluggedKind kind,
         const std::string& firmware) {
  const usb::UsbKind usbKind = usbKindOf(kind);
  const std::vector<usb::FoundUsb> all = usb::findUsb(context, usbKind);
  for (const usb::FoundUsb& found : all) {
    PluggedDevice device;
    device.kind = kind;
    device.which = nameAmong(all, found);
    device.product = productOf(kind, found);
    device.serial = found.serial;
    device.port = found.port;
    device.bus = found.bus;
    device.address = found.address;
    device.highSpeed = found.highSpeed;
    judge(device, usb::troubleInUsing(found, usbKind));
    if (device.state == PluggedState::usable && kind == PluggedKind::board) askBoard(device, found);
    if (device.state == PluggedState::usable && kind == PluggedKind::falcon) lookForFirmware(device, firmware);
    list.push_back(std::move(device));
  }
}

}  // namespace

std::string PluggedDevice::name() const {
  return keywordOf(kind) + (":" + which);
}

std::vector<PluggedDevice> pluggedDevices(const std::string& falconFirmware) {
  const usb::UsbContext context;
  std::vector<PluggedDevice> list;
  for (const PluggedKind kind : {PluggedKind::board, PluggedKind::falcon, PluggedKind::spaceMouse})
    add(list, context, kind, falconFirmware);
  return list;
}

const char* nameOf(PluggedKind kind) {
  constexpr std::array kNames = {"interface board", "Novint Falcon", "SpaceMouse"};
  return kNames[static_cast<std::size_t>(kind)];
}

const char* keywordOf(PluggedKind kind) {
  constexpr std::array kKeywords = {"usb", "falcon", "spacemouse"};
  return kKeywords[static_cast<std::size_t>(kind)];
}

const char* nameOf(PluggedState state) {
  constexpr std::array kNames = {"usable",           "no permission", "held by another program",
                                 "firmware missing", "not homed",     "unusable"};
  return kNames[static_cast<std::size_t>(state)];
}

}  // namespace haptiv
