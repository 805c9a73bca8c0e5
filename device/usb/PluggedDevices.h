#pragma once

#include <stop_token>
#include <string>
#include <vector>

namespace haptiv {

namespace usb {
class UsbContext;
}

enum class PluggedKind { board, falcon, spaceMouse };

/// Whether a device can be used now.
enum class PluggedState {
  usable,
  noPermission,
  held,             ///< by another program
  firmwareMissing,  ///< a Falcon's, which the user has to supply
  notHomed,         ///< a board that has not been told its arm's pose since it was switched on
  silent,           ///< it does not answer
  unusable,         ///< for another reason
};

/// A device of a kind that this program drives or is moved by, as it is plugged in.
struct PluggedDevice {
  PluggedKind kind = PluggedKind::board;
  std::string which;    ///< what it is chosen by: its serial number, or its port where that is not enough
  std::string product;  ///< as it is called
  std::string serial;   ///< empty: none, or it could not be read
  std::string port;     ///< as the kernel writes it: "1-4.2" is bus 1, port 2 of a hub in port 4
  int bus = 0, address = 0;
  bool highSpeed = false;
  PluggedState state = PluggedState::usable;
  std::string trouble;  ///< what keeps it from being used, and what to do; empty: nothing

  /// As after `--device` or `--hand`: "usb:B-0001", "spacemouse:1-4.2".
  std::string name() const;

  bool operator==(const PluggedDevice&) const = default;
};

/// All of them: boards, Falcons, SpaceMice, each in the order of their ports. A board is asked who it is; to others
/// nothing is sent but for their names; those of a kind all at once. Throws UsbFailure where USB devices cannot be
/// listed. Waits, usb::kAnswerLimit where devices of a kind do not answer, however many; not for the servo.
/// @param falconFirmware  file; empty: falcon::firmwarePath()
std::vector<PluggedDevice> pluggedDevices(const std::string& falconFirmware = {});
/// The same by a libusb that is kept, on the thread that handles its events. Asked to stop, it ends early: the list is
/// not whole then.
std::vector<PluggedDevice> pluggedDevices(const usb::UsbContext& context, const std::string& falconFirmware,
                                          const std::stop_token& stop);

/// "interface board", "Novint Falcon", "SpaceMouse".
const char* nameOf(PluggedKind kind);
/// "usb", "falcon", "spacemouse": as `--device` and `--hand` have it.
const char* keywordOf(PluggedKind kind);
/// "usable", "no permission", "held by another program", "firmware missing", "not homed", "does not
/// answer", "unusable".
const char* nameOf(PluggedState state);

}  // namespace haptiv
