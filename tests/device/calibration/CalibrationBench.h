#pragma once

#include "device/calibration/Samples.h"
#include "device/simulated/LoadedHandle.h"
#include "device/simulated/Miscalibration.h"
#include "device/simulated/SimulatedDevice.h"

namespace haptiv::test {

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
    hand->hang(load);
    sampled(50);
  }

  DeviceDescription known = loadDeviceDescription("vishard10"), built;
  std::unique_ptr<LoadedHandle> source = std::make_unique<LoadedHandle>();
  LoadedHandle* hand = source.get();
  SimulatedDevice device;
};

}  // namespace haptiv::test
