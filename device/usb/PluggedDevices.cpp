#include "device/usb/PluggedDevices.h"

#include <array>

#include "device/usb/falcon/FalconFirmware.h"
#include "device/usb/falcon/FalconPort.h"
#include "device/usb/host/BoardRequests.h"
#include "device/usb/libusb/SideBySide.h"
#include "device/usb/libusb/UsbText.h"
#include "device/usb/libusb/UsbTrial.h"
#include "device/usb/spacemouse/SpaceMouseModels.h"

namespace haptiv {
namespace {

PluggedState stateOf(usb::UsbTrouble trouble) {
  if (trouble == usb::UsbTrouble::noPermission) return PluggedState::noPermission;
  if (trouble == usb::UsbTrouble::silent) return PluggedState::silent;
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
    usb::UsbHandle board(found, usb::boardKind(), usb::kAnswerLimit);
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

struct Candidate {
  usb::FoundUsb found;
  PluggedDevice device;
};

Candidate candidateOf(PluggedKind kind, const std::vector<usb::FoundUsb>& all, const usb::FoundUsb& found) {
  PluggedDevice device;
  device.kind = kind;
  device.which = nameAmong(all, found);
  device.product = productOf(kind, found);
  device.serial = found.serial;
  device.port = found.port;
  device.bus = found.bus;
  device.address = found.address;
  device.highSpeed = found.highSpeed;
  return {found, device};
}

void add(std::vector<PluggedDevice>& list, const usb::UsbContext& context, PluggedKind kind,
         const std::string& firmware, const std::stop_token& stop) {
  const usb::UsbKind usbKind = usbKindOf(kind);
  const std::vector<usb::FoundUsb> all = usb::findUsb(context, usbKind);
  std::vector<Candidate> candidates;
  for (const usb::FoundUsb& found : all) candidates.push_back(candidateOf(kind, all, found));
  usb::sideBySide(candidates, [&](Candidate& each) {
    if (stop.stop_requested()) return;
    judge(each.device, usb::troubleInUsing(each.found, usbKind));
    if (each.device.state != PluggedState::usable) return;
    if (kind == PluggedKind::board) askBoard(each.device, each.found);
    if (kind == PluggedKind::falcon) lookForFirmware(each.device, firmware);
  });
  for (Candidate& each : candidates) list.push_back(std::move(each.device));
}

}  // namespace

std::string PluggedDevice::name() const {
  return keywordOf(kind) + (":" + which);
}

std::vector<PluggedDevice> pluggedDevices(const std::string& falconFirmware) {
  return pluggedDevices(usb::UsbContext(), falconFirmware, {});
}

std::vector<PluggedDevice> pluggedDevices(const usb::UsbContext& context, const std::string& falconFirmware,
                                          const std::stop_token& stop) {
  std::vector<PluggedDevice> list;
  for (const PluggedKind kind : {PluggedKind::board, PluggedKind::falcon, PluggedKind::spaceMouse})
    if (!stop.stop_requested()) add(list, context, kind, falconFirmware, stop);
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
                                 "firmware missing", "not homed",     "does not answer",
                                 "unusable"};
  return kNames[static_cast<std::size_t>(state)];
}

}  // namespace haptiv
