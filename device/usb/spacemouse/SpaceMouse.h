#pragma once

#include <memory>
#include <string>

#include "device/usb/spacemouse/SpaceMouseState.h"

namespace haptiv {

/// A SpaceMouse on the USB bus, any that spaceMouseModels() names: its reports are taken by a thread of the link's own.
/// Unplugged, it is at rest and nothing is pressed; plugged in again, it goes on. While it is open the desktop does not
/// have it. Thread: one.
class SpaceMouse {
 public:
  /// Opens it. Throws usb::UsbFailure: none is there, no permission, another program holds it; and what to do.
  /// @param which  its serial number, or, as most have none, its port; empty: the only one there is
  explicit SpaceMouse(const std::string& which = {});
  ~SpaceMouse();

  /// How it stands now. Never waits.
  SpaceMouseState newest();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
