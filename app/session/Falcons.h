#pragma once

#include <string>

#include "device/usb/falcon/FalconDevice.h"

namespace haptiv {

/// Whether a device by its name, as after `--device`, is a Novint Falcon: "falcon", or "falcon:WHICH".
bool isFalcon(const std::string& device);
/// Which one it is, and what it is set up with.
/// @param firmware  file; empty: where it is looked for
FalconChoice falconChoiceOf(const std::string& device, const std::string& firmware);

}  // namespace haptiv
