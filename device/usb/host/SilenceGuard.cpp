#include "device/usb/host/SilenceGuard.h"

#include <algorithm>

namespace haptiv::usb {

DeviceCommand SilenceGuard::restrain(DeviceCommand command) const noexcept {
  if (!answers()) return {command.mode};
  if (misses_ < kMisses) return command;
  const double rampFrom = (kMisses - 1) * period_;
  const double left = std::clamp((kLongest - silence()) / (kLongest - rampFrom), 0., 1.);
  command.jointRates *= left;
  command.jointTorques *= left;
  return command;
}

}  // namespace haptiv::usb
