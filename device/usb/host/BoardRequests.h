#pragma once

#include "device/usb/libusb/UsbHandle.h"
#include "device/usb/protocol/BoardProfile.h"
#include "device/usb/protocol/ControlFrames.h"
#include "device/usb/protocol/StreamFrames.h"

namespace haptiv::usb {

/// How an interface board is known on the bus: docs/usb-protocol.md.
UsbKind boardKind();

/// The control requests of docs/usb-protocol.md, in words. Each waits for the board's answer; each throws UsbFailure,
/// `wrongDevice` where the answer is not that of a board which speaks this version of the protocol.
Identity askIdentity(UsbHandle& board);
Capabilities askCapabilities(UsbHandle& board);
CircuitThresholds askThresholds(UsbHandle& board);
void setThresholds(UsbHandle& board, const CircuitThresholds& thresholds);
/// The encoders shall report these counts at the arm's present pose. Refused while the drives are on.
void setHome(UsbHandle& board, const HomeCounts& counts);
/// By the size of the state's packets.
FrameForm frameFormOf(const UsbHandle& board);

}  // namespace haptiv::usb
