#pragma once

#include "device/calibration/Samples.h"
#include "device/simulated/Miscalibration.h"
#include "device/simulated/SimulatedDevice.h"

namespace haptiv::test {

/// Hangs a load on the handle, or nothing, and holds it still.
class LoadingHand : public HandSource {
 public:
  HandTarget at(double) noexcept override {
    HandTarget target;
    target.inputs = 0;
    target.load = load;
    return target;
  }
  Wrench load;
};

/// A simulated arm that is not as its description says, standing in its reference pose.
struct CalibrationBench {
  explicit CalibrationBench(std::uint64_t seed = 1)
      : built(miscalibrated(known, seed)), device(built, known.encoders.reference, std::move(source), seed) {
    device.start(1e-3);
  }
  Samples sampled(int ticks) {
    Samples samples;
    for (int i = 0; i < ticks; ++i) {
      device.write({});
      samples.take(device.read());
    }
    return samples;
  }
  void hang(const Vector6& load) {
    hand->load = {load.head<3>(), load.tail<3>()};
    sampled(50);
  }

  DeviceDescription known = loadDeviceDescription("vishard10"), built;
  std::unique_ptr<LoadingHand> source = std::make_unique<LoadingHand>();
  LoadingHand* hand = source.get();
  SimulatedDevice device;
};

}  // namespace haptiv::test
