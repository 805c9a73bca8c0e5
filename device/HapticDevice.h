#pragma once

#include "device/safety/SafetySignals.h"
#include "device/types.h"

namespace haptiv {

class Homing;

/// What a device reports once per tick: raw counts, as the hardware has them, so that a log of them is lossless.
/// DeviceDescription turns them into radians, newtons and newton metres.
struct DeviceReading {
  std::array<std::int32_t, kJointCount> encoderCounts{};
  std::array<std::int16_t, 6> sensorCounts{};  ///< force x y z, torque x y z of the hand on the handle, in T
  std::uint16_t inputs = kInputDeadMan;        ///< OperatorInput bits
  std::uint32_t trips = kNoTrip;               ///< Trip bits: why the device's safety circuit has stopped the drives
  bool connected = true;                       ///< false: the counts are the last ones known
  std::int64_t deviceTime = 0;  ///< of the counts, by the device's own clock [us]; 0: it has none, or none that is told
};

/// What the set-points of a command mean.
enum class DriveMode : std::uint8_t { rate, torque };

/// What the host asks of the joints for the coming tick.
struct DeviceCommand {
  DriveMode mode = DriveMode::rate;
  JointVector jointRates = JointVector::Zero();    ///< set-points of velocity-controlled drives [rad/s]; mode rate
  JointVector jointTorques = JointVector::Zero();  ///< set-points of torque-controlled drives [N m]; mode torque
  bool enabled = false;                            ///< false: the drives brake and ignore the set-points
};

/// The one door between the servo and an arm: simulated, over USB, or replayed from a log.
///
/// start and stop belong to the thread that owns the session and may throw std::runtime_error naming the remedy.
/// read and write belong to the servo thread: realtime-safe but for the device's own I/O, never throwing.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;

  /// Makes the device ready at a known pose. `period` is the servo's tick [s].
  virtual void start(double period) = 0;
  /// The newest state of the device. Realtime-safe: yes.  Thread: servo.
  virtual DeviceReading read() noexcept = 0;
  /// Set-points for the coming tick. Realtime-safe: yes.  Thread: servo.
  virtual void write(const DeviceCommand& command) noexcept = 0;
  /// Brakes the arm; the device can be started again.
  virtual void stop() = 0;

  /// How its encoders are given a zero; null: they keep their own, or cannot be given one.
  virtual Homing* homing() noexcept { return nullptr; }
};

}  // namespace haptiv
