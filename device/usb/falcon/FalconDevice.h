#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "device/HapticDevice.h"
#include "device/HostButtons.h"
#include "device/described/DeviceDescription.h"
#include "device/usb/falcon/FalconClient.h"

namespace haptiv {

/// Which Falcon, and what it is set up with.
struct FalconChoice {
  std::string which;                             ///< serial number or port; empty: the only one there is
  std::string firmware;                          ///< file; empty: falcon::firmwarePath()
  std::function<void(const std::string&)> tell;  ///< gets what the operator has to do meanwhile; may be empty
  std::chrono::seconds homingTime{60};           ///< that the operator has for it
  std::function<bool()> cancelled;               ///< whether nobody waits for it any more; may be empty
};

/// A Novint Falcon over USB; docs/falcon.md: what is known of it, and what nobody could verify.
///
/// An impedance-type device: a command's torques go to its three motors, a command by rates drives nothing. It has no
/// brakes and no safety circuit of its own: whatever stops it is the host, so a host that dies leaves the last torque
/// standing for as long as the firmware does, which is not known.
class FalconDevice : public HapticDevice, public HostButtons {
 public:
  /// Throws std::runtime_error where the description's arm is no Falcon.
  explicit FalconDevice(const DeviceDescription& description, FalconChoice choice = {});
  ~FalconDevice() override;

  /// Opens it, brings the firmware in where it is not there, and waits until the operator has homed it. Throws
  /// std::runtime_error: what is wrong, and what to do.
  void start(double period) override;
  /// Not connected: unplugged, silent, or without its zeros.
  DeviceReading read() noexcept override;
  void write(const DeviceCommand& command) noexcept override;
  /// Waits until an order without torque has gone out, 20 ms at most.
  void stop() override;

  /// An emergency stop takes the torque away with the next order, and is in the readings.
  void press(std::uint16_t inputs) noexcept override;

  falcon::Figures figures() const;  ///< thread: any but the servo's

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
