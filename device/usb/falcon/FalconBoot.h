#pragma once

#include <functional>
#include <string>

#include "device/usb/falcon/SerialPort.h"

namespace haptiv::falcon {

/// Brings a Falcon to where it answers orders by states.
///
/// One that answers already keeps the firmware that it has. Otherwise its loader is woken by the chip's DTR line at
/// 9600 baud, asked for its name, and given the firmware at 140,000 baud, in blocks that it sends back; then it runs,
/// at 1,456,312 baud. The order of these steps, and what the loader says, are what others have seen; docs/falcon.md.
///
/// Tried three times: the loader is said to need that. Throws std::runtime_error that says at which step it failed, and
/// what to do.
/// @param firmware  called only where it is needed: the file's bytes, or what it throws
void boot(SerialPort& port, const std::function<std::vector<std::uint8_t>()>& firmware);

}  // namespace haptiv::falcon
