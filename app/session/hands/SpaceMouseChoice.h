#pragma once

#include <optional>
#include <string>

#include "app/session/hands/SpaceMouseHand.h"

namespace haptiv {

/// Which SpaceMouse is the hand, and how it moves it.
struct SpaceMouseChoice {
  SpaceMouseHand::Mode mode = SpaceMouseHand::Mode::velocity;
  std::string which;  ///< serial number or port; empty: the only one there is
  bool operator==(const SpaceMouseChoice&) const = default;
};

/// By its name as after `--hand`: "spacemouse", "spacemouse:position", each with ":WHICH" behind it where there are
/// several. Nothing: it is no SpaceMouse's name.
std::optional<SpaceMouseChoice> spaceMouseNamed(const std::string& hand);

}  // namespace haptiv
