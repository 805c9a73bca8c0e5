#pragma once

#include <stdexcept>
#include <string>

#include "device/described/DeviceDescription.h"

namespace haptiv {

/// The message with which a description named arm.toml is refused; empty when it is accepted.
inline std::string refusal(const std::string& toml) {
  try {
    parseDeviceDescription(toml, "arm.toml");
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

}  // namespace haptiv
