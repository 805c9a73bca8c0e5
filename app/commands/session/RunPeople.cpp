#include "app/commands/session/RunPeople.h"

#include <iostream>
#include <string_view>

#include "app/session/hands/SpaceMouseOperator.h"
#include "device/usb/falcon/FalconDevice.h"

namespace haptiv {
namespace {

constexpr std::string_view kFalconOf = "falcon:";  // and its serial number
constexpr std::string_view kByPosition = "spacemouse:position";

}  // namespace

bool isFalcon(const std::string& device) {
  return device == "falcon" || device.starts_with(kFalconOf);
}

std::function<std::unique_ptr<HapticDevice>()> falconOf(const std::string& device, const std::string& firmware,
                                                        const DeviceDescription& description) {
  FalconChoice choice;
  if (device.starts_with(kFalconOf)) choice.serial = device.substr(kFalconOf.size());
  choice.firmware = firmware;
  choice.tell = [](const std::string& what) { std::cerr << what << std::endl; };
  return [description, choice] { return std::make_unique<FalconDevice>(description, choice); };
}

bool isSpaceMouse(const std::string& hand) {
  return hand == "spacemouse" || hand == kByPosition;
}

LiveOperator operatorOf(const std::string& hand, const SessionSetup& setup) {
  if (!isSpaceMouse(hand)) return {};
  const auto mode = hand == kByPosition ? SpaceMouseHand::Mode::position : SpaceMouseHand::Mode::velocity;
  const auto mouse = std::make_shared<SpaceMouseOperator>(mode, setup.description, setup.scene->device);
  return [mouse](Session& session, const TickRecord& newest) {
    const SpaceMouseHand::Wish wish = mouse->wish(newest);
    session.moveHand(wish.place, wish.rotation);
    session.press(wish.inputs);
  };
}

}  // namespace haptiv
