#pragma once

#include "device/simulated/Hand.h"

namespace haptiv {

/// Nobody's hand: a weight hangs on the handle, or nothing. Nobody holds the dead-man's button.
class LoadedHandle : public HandSource {
 public:
  HandTarget at(double) noexcept override {
    HandTarget target;
    target.inputs = 0;
    target.load = load_;
    return target;
  }
  /// From now on: force and torque on the handle, in T [N], [N m].  Thread: that of at.
  void hang(const Vector6& load) noexcept { load_ = {load.head<3>(), load.tail<3>()}; }

 private:
  Wrench load_;
};

}  // namespace haptiv
