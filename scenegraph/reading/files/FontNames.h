#pragma once

#include <string>

namespace haptiv {

/// The font that the system, and with it Coin, takes in place of one that it has not; empty where it has the font.
/// @param name  as a Font node gives it: FAMILY or FAMILY:STYLE
std::string fontInPlaceOf(const std::string& name);

}  // namespace haptiv
