#include "device/usb/spacemouse/SpaceMouseModels.h"

#include <algorithm>

namespace haptiv {

std::span<const SpaceMouseModel> spaceMouseModels() noexcept {
  static constexpr SpaceMouseModel kModels[] = {
      {0x046d, 0xc626, "SpaceNavigator"},
      {0x046d, 0xc627, "SpaceExplorer"},
      {0x046d, 0xc628, "SpaceNavigator for Notebooks"},
      {0x046d, 0xc629, "SpacePilot Pro"},
      {0x046d, 0xc62b, "SpaceMouse Pro"},
      {0x256f, 0xc62e, "SpaceMouse Wireless, by its cable"},
      {0x256f, 0xc62f, "SpaceMouse Wireless, by its receiver"},
      {0x256f, 0xc631, "SpaceMouse Pro Wireless, by its cable"},
      {0x256f, 0xc632, "SpaceMouse Pro Wireless, by its receiver"},
      {0x256f, 0xc633, "SpaceMouse Enterprise"},
      {0x256f, 0xc635, "SpaceMouse Compact"},
      {0x256f, 0xc652, "3Dconnexion Universal Receiver"},
  };
  return kModels;
}

usb::UsbKind spaceMouseKind() {
  usb::UsbKind kind{"SpaceMouse", {}, 0};
  for (const SpaceMouseModel& model : spaceMouseModels()) kind.ids.push_back({model.vendor, model.product});
  return kind;
}

const SpaceMouseModel* spaceMouseModel(std::uint16_t vendor, std::uint16_t product) noexcept {
  const auto models = spaceMouseModels();
  const auto found = std::find_if(models.begin(), models.end(), [&](const SpaceMouseModel& model) {
    return model.vendor == vendor && model.product == product;
  });
  return found == models.end() ? nullptr : &*found;
}

}  // namespace haptiv
