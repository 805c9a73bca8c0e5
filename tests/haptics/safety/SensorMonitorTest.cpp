#include "haptics/safety/SensorMonitor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "device/described/DeviceDescription.h"
#include "device/simulated/Noise.h"
#include "haptics/safety/Faults.h"
#include "tests/haptics/safety/MonitorPeriod.h"

namespace haptiv {
namespace {

using testing::kMonitorPeriod;

class SensorMonitorTest : public ::testing::Test {
 protected:
  /// Faults of `ticks` ticks in which the force is the noise, but for an axis that is stuck.
  std::uint32_t watch(int ticks, int stuck) {
    const SensorMonitor monitor(description, kMonitorPeriod);
    SensorState state;
    Noise noise(3);
    std::uint32_t faults = kNoFault;
    for (int i = 0; i < ticks; ++i) {
      DeviceReading reading;
      for (int axis = 0; axis < 6; ++axis) {
        const double sigma = axis < 3 ? description.sensor.forceNoise / description.sensor.forceResolution
                                      : description.sensor.torqueNoise / description.sensor.torqueResolution;
        const double counts = axis == stuck ? 17 : sigma * noise.next();
        reading.sensorCounts[static_cast<std::size_t>(axis)] = static_cast<std::int16_t>(std::lround(counts));
      }
      faults |= monitor(reading, {}, state);
    }
    return faults;
  }
  DeviceDescription description = loadDeviceDescription("vishard10");
};

TEST_F(SensorMonitorTest, FindsAnAxisThatIsStuck) {
  for (int axis = 0; axis < 6; ++axis) {
    EXPECT_EQ(watch(50, axis), kNoFault);
    EXPECT_EQ(watch(150, axis), kFaultSensorStuck);
  }
}

TEST_F(SensorMonitorTest, IsNotAlarmedByAHealthySensorNorByOneWithoutNoise) {
  EXPECT_EQ(watch(200'000, -1), kNoFault);
  description.sensor.forceNoise = description.sensor.torqueNoise = 0;
  EXPECT_EQ(watch(200'000, -1), kNoFault);
}

TEST_F(SensorMonitorTest, FindsAForceThatNoHandHas) {
  const SensorMonitor monitor(description, kMonitorPeriod);
  SensorState state;
  Measured measured;
  measured.handForce = {0, 290, 0};
  EXPECT_EQ(monitor({}, measured, state), kNoFault);
  measured.handForce = {0, 290, 90};
  EXPECT_EQ(monitor({}, measured, state), kFaultHandForce);
}

}  // namespace
}  // namespace haptiv
