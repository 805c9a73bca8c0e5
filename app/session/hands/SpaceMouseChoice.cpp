#include "app/session/hands/SpaceMouseChoice.h"

#include <string_view>

namespace haptiv {
namespace {

/// What follows `head` and a colon; "" where nothing does; nothing where the text is another one.
std::optional<std::string> after(std::string_view head, std::string_view text) {
  if (text == head) return "";
  if (!text.starts_with(head) || text[head.size()] != ':') return std::nullopt;
  return std::string(text.substr(head.size() + 1));
}

}  // namespace

std::optional<SpaceMouseChoice> spaceMouseNamed(const std::string& hand) {
  using Mode = SpaceMouseHand::Mode;
  if (const auto which = after("spacemouse:position", hand)) return SpaceMouseChoice{Mode::position, *which};
  if (const auto which = after("spacemouse", hand)) return SpaceMouseChoice{Mode::velocity, *which};
  return std::nullopt;
}

}  // namespace haptiv
