#pragma once

#include <cstdint>

namespace haptiv {

/// What a device has whose operator can press buttons at the host too, beside those at the device itself.
class HostButtons {
 public:
  virtual ~HostButtons() = default;
  /// OperatorInput bits as levels: reset and emergency stops count, the dead-man's button is at the device alone.
  /// Thread: any.  Realtime-safe: yes.
  virtual void press(std::uint16_t inputs) noexcept = 0;
};

}  // namespace haptiv
