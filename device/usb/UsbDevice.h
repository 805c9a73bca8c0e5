#pragma once

#include <memory>
#include <optional>
#include <string>

#include "device/HapticDevice.h"
#include "device/Homing.h"
#include "device/HostButtons.h"
#include "device/described/DeviceDescription.h"
#include "device/realtime/TimeHistogram.h"
#include "device/usb/host/LinkCounters.h"
#include "device/usb/protocol/ControlFrames.h"

namespace haptiv {

/// Which board, and what to do with it.
struct UsbDeviceChoice {
  std::string serial;  ///< or its port; empty: the only one there is
  std::optional<usb::HomeCounts>
      home;              ///< the arm stands where its encoders should say this: homes a board that is not
  bool unhomed = false;  ///< a board without a zero is read too; it is never driven
};

/// An arm behind an interface board, over USB: docs/usb.md. The servo's side of the link; what it does when a packet is
/// missing, when the board is silent and when it is unplugged, is the fault policy told there.
class UsbDevice : public HapticDevice, public Homing, public HostButtons {
 public:
  explicit UsbDevice(const DeviceDescription& description, UsbDeviceChoice choice = {});
  ~UsbDevice() override;

  /// Opens the board, and waits 100 ms at most for its first state; readings are not connected before there is one.
  /// Throws usb::UsbFailure: what is wrong, and what to do.
  void start(double period) override;
  DeviceReading read() noexcept override;
  void write(const DeviceCommand& command) noexcept override;
  /// The drives are disabled first, and the board is given 20 ms to say so.
  void stop() override;

  /// What the operator presses at the host, as a level: a reset is passed on, an emergency stop asks for the board's
  /// trip. Thread: any.  Realtime-safe: yes.
  void press(std::uint16_t inputs) noexcept override;

  Homing* homing() noexcept override { return this; }
  bool homed() const override;
  /// Throws usb::UsbFailure. After the board was unplugged as before.
  void home(const PoseCounts& counts) override;

  // Thread: any but the servo's; before the first start all is empty.
  usb::LinkFigures figures() const;
  TimeDistribution latencies() const;  ///< from write until the board's echo came in [ns]
  std::string serial() const;
  std::string trouble() const;  ///< why the board is not there; empty: it is
  bool highSpeed() const;       ///< full frames

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
