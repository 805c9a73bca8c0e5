#pragma once

#include <ostream>
#include <vector>

#include "device/usb/PluggedDevices.h"

namespace haptiv {

/// One table of what can be driven, and of what can be the hand: a line each, and what to do where one cannot be used.
/// Says what to do where nothing is plugged in.
void printDevices(std::ostream& out, const std::vector<PluggedDevice>& devices);

}  // namespace haptiv
