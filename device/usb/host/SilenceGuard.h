#pragma once

#include "device/HapticDevice.h"

namespace haptiv::usb {

/// What the host does while a board says nothing new: kMisses ticks in a row it waits; then the set-points go down to
/// zero on a ramp, and kLongest after the last state the drives are disabled.
class SilenceGuard {
 public:
  static constexpr int kMisses = 3;
  static constexpr double kLongest = 0.010;  ///< [s]

  /// @param period  of the servo [s]
  explicit SilenceGuard(double period) noexcept : period_(period) {}

  /// Once a tick: whether a new state has come. Realtime-safe: yes.
  void tick(bool fresh) noexcept { misses_ = fresh ? 0 : misses_ + 1; }
  /// False: the counts are old, and the arm is not to be driven by them. Realtime-safe: yes.
  bool answers() const noexcept { return silence() < kLongest * (1 - 1e-9); }
  /// The command as far as the silence allows. Realtime-safe: yes.
  DeviceCommand restrain(DeviceCommand command) const noexcept;

 private:
  double silence() const noexcept { return static_cast<double>(misses_) * period_; }

  double period_;
  std::int64_t misses_ = 0;  // in a row
};

}  // namespace haptiv::usb
