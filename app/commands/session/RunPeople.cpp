#include "app/commands/session/RunPeople.h"

#include <iostream>

#include "app/session/Falcons.h"
#include "app/session/hands/SpaceMouseOperator.h"

namespace haptiv {

std::function<std::unique_ptr<HapticDevice>()> falconOf(const std::string& device, const std::string& firmware,
                                                        const DeviceDescription& description) {
  FalconChoice choice = falconChoiceOf(device, firmware);
  choice.tell = [](const std::string& what) { std::cerr << what << std::endl; };
  return [description, choice] { return std::make_unique<FalconDevice>(description, choice); };
}

LiveOperator operatorOf(const std::string& hand, const SessionSetup& setup) {
  const std::optional<SpaceMouseChoice> choice = spaceMouseNamed(hand);
  if (!choice) return {};
  const auto mouse = std::make_shared<SpaceMouseOperator>(*choice, setup.description, setup.scene->device);
  return [mouse](Session& session, const TickRecord& newest) {
    const SpaceMouseHand::Wish wish = mouse->wish(newest);
    session.moveHand(wish.place, wish.rotation);
    session.press(wish.inputs);
  };
}

}  // namespace haptiv
