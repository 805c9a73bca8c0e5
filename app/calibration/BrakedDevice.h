#pragma once

#include <memory>
#include <string>

#include "app/calibration/QuietMeasurement.h"
#include "device/HapticDevice.h"
#include "device/simulated/LoadedHandle.h"

namespace haptiv {

/// A device that is read while its arm is braked. Thread: one.
class BrakedDevice {
 public:
  static constexpr double kPeriod = 1e-3;       ///< of its ticks [s]
  static constexpr std::int64_t kSettle = 100;  ///< ticks after which a load that was hung on hangs still, simulated

  /// The arm of a description as it might have been put together (miscalibrated), standing in the reference pose.
  static BrakedDevice simulated(const DeviceDescription& description, std::uint64_t seed);
  /// By a name as after `--device`: "sim", or an interface board, homed or not. Throws as UsbDevice::start does.
  static BrakedDevice named(const std::string& device, const DeviceDescription& description, std::uint64_t seed);
  /// Any device, started here. Throws as HapticDevice::start does.
  explicit BrakedDevice(std::unique_ptr<HapticDevice> device);
  BrakedDevice(BrakedDevice&&) = default;
  ~BrakedDevice();

  /// One tick: brakes, and reads.
  DeviceReading tick();
  /// So many ticks, a simulated arm's as fast as they can be had, others' by the clock.
  QuietMeasurement measure(std::int64_t ticks);

  /// What hangs on the handle of a simulated arm; null of any other, which people load.
  LoadedHandle* handle() noexcept { return handle_; }
  bool isSimulated() const noexcept { return handle_ != nullptr; }
  Homing* homing() noexcept { return device_->homing(); }
  /// Whether the encoders have lost their zero: what they count means nothing.
  bool isLost() const;
  /// Tells encoders that have, that the arm stands in the description's reference pose.
  /// @param measured  meanwhile; throws CalibrationRefused where the arm did not stand
  void findAgain(const QuietMeasurement& measured, const DeviceDescription& description);

 private:
  BrakedDevice(std::unique_ptr<HapticDevice> device, LoadedHandle* handle);

  std::unique_ptr<HapticDevice> device_;
  LoadedHandle* handle_ = nullptr;  // the device's
};

}  // namespace haptiv
