#pragma once

#include <cstdint>
#include <memory>

#include "device/HapticDevice.h"
#include "device/Homing.h"
#include "device/described/DeviceDescription.h"
#include "device/simulated/Hand.h"
#include "device/simulated/InjectedFaults.h"

namespace haptiv {

/// An arm, its drives, its sensors, its interface board with the safety circuit, and an operator, in place of the
/// hardware; deterministic for a given seed. The servo code cannot tell it from a real device. SimulatedArm says what
/// of the arm is modelled.
///
/// Its time is the servo's: a write advances it by one period, with the set-points held. A start begins anew.
/// The operator's buttons count from the first write on: a dead-man that is held before starts nothing.
class SimulatedDevice : public HapticDevice, public Homing {
 public:
  /// @param start  joint angles at which the arm stands and the session begins [rad], rounded to encoder counts
  /// @param hand   null: nobody at the handle, the dead-man's button held down by other means
  /// Throws std::runtime_error where an angle is not finite.
  SimulatedDevice(const DeviceDescription& description, const JointVector& start, std::unique_ptr<HandSource> hand,
                  std::uint64_t seed);
  ~SimulatedDevice() override;

  /// Throws std::runtime_error unless 0 < period <= 0.1.
  void start(double period) override;
  DeviceReading read() noexcept override;
  void write(const DeviceCommand& command) noexcept override;
  void stop() override;
  Homing* homing() noexcept override { return this; }

  bool homed() const override { return true; }  ///< its encoders keep the description's zero
  /// Lasts until the next start, which begins with encoders that have the description's zero.
  void home(const PoseCounts& counts) override;

  /// Breaks what is named, and mends the rest, from the next write on; kept over a start. For tests.
  /// Realtime-safe: yes.  Thread: that of write.
  void inject(const InjectedFaults& faults) noexcept;
  /// How the arm really is, whatever the sensors say. Realtime-safe: yes.  Thread: that of write.
  struct Truth {
    JointVector angles, rates;  ///< [rad], [rad/s]
    JointVector torques;        ///< of the motors, at the joints [N m]
    Wrench hand;                ///< on the handle, in B
    bool driving = false;       ///< false: the motors brake
  };
  Truth truth() const noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
