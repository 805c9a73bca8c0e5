#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "device/usb/libusb/UsbContext.h"
#include "device/usb/libusb/UsbFailure.h"

struct libusb_device;

namespace haptiv::usb {

struct UsbId {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  bool operator==(const UsbId&) const = default;
};

/// What kind of device is looked for, and what it is called in messages.
struct UsbKind {
  std::string name;        ///< such as "Haptiv interface board"
  std::vector<UsbId> ids;  ///< any of them
  int interface = 0;       ///< that is claimed
};

/// A device that is plugged in.
struct FoundUsb {
  UsbId id;
  int bus = 0, address = 0;
  std::string port;  ///< where it is plugged in, as the kernel writes it: "1-4.2", bus 1, port 2 of a hub in port 4
  bool highSpeed = false;             ///< 480 Mbit/s or more
  std::string serial;                 ///< empty: it has none, or it could not be read
  std::string product;                ///< as it calls itself
  std::optional<UsbFailure> trouble;  ///< why it cannot be opened; nothing: it can
  std::shared_ptr<libusb_device> device;

  /// "Haptiv interface board B-0001 at bus 1, device 4"
  std::string describedAs(const UsbKind& kind) const;
};

/// All devices of a kind that are plugged in, in the order of bus and address. Opens each shortly, all side by side, to
/// read its serial number. Never throws for a single device: its `trouble` tells, also that it does not answer, for
/// which this waits `kAnswerLimit`.
std::vector<FoundUsb> findUsb(const UsbContext& context, const UsbKind& kind);

/// What to call one of them by, so that no other is meant: its serial number; where it has none, or another has the
/// same, its port.
std::string nameAmong(const std::vector<FoundUsb>& all, const FoundUsb& one);

/// The one that is meant: with this serial number, or else in this port; or the only one where `which` is empty.
/// Throws UsbFailure (notFound, ambiguous, noPermission ...) that says which there are and what to do.
FoundUsb findOne(const UsbContext& context, const UsbKind& kind, const std::string& which);

}  // namespace haptiv::usb
