#pragma once

#include <string>

#include "app/commands/ExitCode.h"

namespace haptiv {

/// Refuses a device's name, as after `--device` or `--hand`, that ends where the one that is meant should follow.
inline void refuseWithoutName(const std::string& device) {
  if (!device.ends_with(':')) return;
  throw CommandFailure(kWrongUsage, device +
                                        " which one? Give its serial number or port behind the colon, as haptiv device "
                                        "list names them, or leave the colon out");
}

}  // namespace haptiv
