#pragma once

#include <filesystem>
#include <string>

namespace haptiv {

/// What this machine's kernel offers for importing a USB device by USB/IP, and what to do, line by line.
struct VhciHint {
  bool ready = false;  ///< the virtual host controller is there
  std::string advice;  ///< what is missing, and the commands that attach the board
};

/// @param system  where /sys and /lib/modules are: "/" but in tests
/// @param release  of the running kernel, as uname -r has it
VhciHint vhciHint(const std::filesystem::path& system, const std::string& release, const std::string& address,
                  int port);
/// Of this machine.
VhciHint vhciHint(const std::string& address, int port);

}  // namespace haptiv
