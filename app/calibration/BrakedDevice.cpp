#include "app/calibration/BrakedDevice.h"

#include <chrono>
#include <thread>
#include <utility>

#include "app/session/UsbBoards.h"
#include "device/Homing.h"
#include "device/calibration/QuietCheck.h"
#include "device/simulated/Miscalibration.h"
#include "device/simulated/SimulatedDevice.h"

namespace haptiv {
namespace {

constexpr int kFirstWord = 1000;  // [ms] that a device is given to say its first

}  // namespace

BrakedDevice BrakedDevice::simulated(const DeviceDescription& description, std::uint64_t seed) {
  auto source = std::make_unique<LoadedHandle>();
  LoadedHandle* handle = source.get();
  return {std::make_unique<SimulatedDevice>(miscalibrated(description, seed), description.encoders.reference,
                                            std::move(source), seed),
          handle};
}

BrakedDevice BrakedDevice::named(const std::string& device, const DeviceDescription& description, std::uint64_t seed) {
  if (!isBoard(device)) return simulated(description, seed);
  constexpr bool kUnhomed = true;  // it may be
  return BrakedDevice(
      std::make_unique<UsbDevice>(description, UsbDeviceChoice{boardSerialOf(device), std::nullopt, kUnhomed}));
}

BrakedDevice::BrakedDevice(std::unique_ptr<HapticDevice> device) : BrakedDevice(std::move(device), nullptr) {
  // Until it has spoken; what is measured of one that never does, is refused.
  for (int i = 0; i < kFirstWord && !tick().connected; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

BrakedDevice::BrakedDevice(std::unique_ptr<HapticDevice> device, LoadedHandle* handle)
    : device_(std::move(device)), handle_(handle) {
  device_->start(kPeriod);
}

BrakedDevice::~BrakedDevice() {
  if (device_) device_->stop();
}

DeviceReading BrakedDevice::tick() {
  device_->write({});
  return device_->read();
}

bool BrakedDevice::isLost() const {
  const Homing* homing = device_->homing();
  return homing != nullptr && !homing->homed();
}

void BrakedDevice::findAgain(const QuietMeasurement& measured, const DeviceDescription& description) {
  if (!isLost()) return;
  expectArmStands(measured.first(), description);
  expectArmStands(measured.second(), description);
  device_->homing()->home(description.countsAt(description.encoders.reference));
}

QuietMeasurement BrakedDevice::measure(std::int64_t ticks) {
  QuietMeasurement measured(ticks);
  auto next = std::chrono::steady_clock::now();
  while (!measured.isDone()) {
    measured.take(tick());
    if (!isSimulated()) std::this_thread::sleep_until(next += std::chrono::milliseconds(1));
  }
  return measured;
}

}  // namespace haptiv
