#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "device/usb/libusb/UsbFinder.h"

namespace haptiv {

/// A device of 3Dconnexion's that can be a hand.
struct SpaceMouseModel {
  std::uint16_t vendor;
  std::uint16_t product;
  std::string_view name;
};

/// Those that are known by their numbers; docs/spacemouse.md has the layouts of their reports.
std::span<const SpaceMouseModel> spaceMouseModels() noexcept;

/// How they are found.
usb::UsbKind spaceMouseKind();

/// Null: none of them.
const SpaceMouseModel* spaceMouseModel(std::uint16_t vendor, std::uint16_t product) noexcept;

}  // namespace haptiv
