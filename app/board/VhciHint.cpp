#include "app/board/VhciHint.h"

#include <sys/utsname.h>

#include <fstream>

#include "app/board/usbip/Messages.h"

namespace haptiv {
namespace {

namespace fs = std::filesystem;

/// Whether the module can be loaded: the index of the kernel's modules names it.
bool hasModule(const fs::path& system, const std::string& release) {
  std::ifstream index(system / "lib/modules" / release / "modules.dep");
  for (std::string line; std::getline(index, line);) {
    if (line.substr(0, line.find(':')).find("vhci-hcd.ko") != std::string::npos) return true;
  }
  return false;
}

std::string attachment(const std::string& address, int port) {
  const std::string remote = address == "0.0.0.0" || address == "127.0.0.1" ? "localhost" : address;
  const std::string other = port == usbip::kDefaultPort ? "" : " --tcp-port " + std::to_string(port);
  return "usbip" + other + " attach -r " + remote + " -b 1-1";
}

}  // namespace

VhciHint vhciHint(const fs::path& system, const std::string& release, const std::string& address, int port) {
  const std::string attach =
      "\n  sudo " + attachment(address, port) +
      "\nand then, in another terminal,\n  haptiv run SCENE --device usb\n"
      "`usbip port` lists what is attached, `sudo usbip detach -p 00` unplugs it. The command is in "
      "Debian's package usbip.";
  std::error_code error;
  if (fs::exists(system / "sys/devices/platform/vhci_hcd.0", error))
    return {true, "This kernel's virtual host controller is there. Plug the board in with" + attach};
  if (hasModule(system, release))
    return {false,
            "This kernel's virtual host controller is not loaded. Load it and plug the board in with"
            "\n  sudo modprobe vhci-hcd" +
                attach};
  return {false,
          "This kernel (" + release +
              ") has no virtual host controller: the module vhci-hcd is not among its modules, "
              "so the board cannot be plugged in on this machine. Boot a kernel with CONFIG_USBIP_VHCI_HCD=m, such as "
              "Debian's linux-image-amd64, or serve it with --bind to a machine that has one, and there\n"
              "  sudo modprobe vhci-hcd" +
              attach};
}

VhciHint vhciHint(const std::string& address, int port) {
  utsname names{};
  ::uname(&names);
  return vhciHint("/", names.release, address, port);
}

}  // namespace haptiv
