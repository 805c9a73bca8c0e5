/// A device whose encoders have lost their zero, as a board that has just been switched on.
#include <gtest/gtest.h>

#include "app/calibration/BrakedDevice.h"
#include "app/calibration/Calibration.h"
#include "device/calibration/CalibrationRefused.h"
#include "device/usb/virtual/VirtualBoard.h"

namespace haptiv {
namespace {

/// A virtual board without a bus between.
class LostBoard : public HapticDevice, public Homing {
 public:
  explicit LostBoard(const DeviceDescription& description)
      : board_({.description = description, .homed = false}, nullptr) {}

  void start(double) override {}
  DeviceReading read() noexcept override {
    DeviceReading reading = board_.report().reading;
    reading.connected = homed_;
    reading.encoderCounts[0] += drift;
    return reading;
  }
  void write(const DeviceCommand&) noexcept override {
    for (int i = 0; i < 8; ++i) board_.advance();
    drift += turning;
  }
  void stop() override {}
  Homing* homing() noexcept override { return this; }
  bool homed() const override { return homed_; }
  void home(const PoseCounts& counts) override {
    usb::ControlBytes bytes{};
    homed_ = board_.port().controlOut(5, usb::encode(counts, bytes));
  }

  int turning = 0;  // counts of joint 1 a tick, by somebody's hand

 private:
  usb::VirtualBoard board_;
  bool homed_ = false;
  int drift = 0;
};

struct Lost : testing::Test {
  DeviceDescription description = loadDeviceDescription("vishard10");
  std::unique_ptr<LostBoard> made = std::make_unique<LostBoard>(description);
  LostBoard* board = made.get();
  BrakedDevice device{std::move(made)};
};

TEST_F(Lost, IsToldTheCountsOfTheReferencePoseAndReportsThem) {
  EXPECT_TRUE(device.isLost());
  device.findAgain(device.measure(400), description);
  EXPECT_FALSE(device.isLost());
  Calibration calibration(description);
  const FoundZero found = calibration.takeZero(device.measure(400), false);
  EXPECT_LT(found.zero.cwiseAbs().maxCoeff(), 20) << "the description's zeros hold again";
}

TEST_F(Lost, IsToldNothingWhileTheArmIsMoved) {
  board->turning = 5;
  EXPECT_THROW(device.findAgain(device.measure(400), description), CalibrationRefused);
  EXPECT_TRUE(device.isLost());
}

}  // namespace
}  // namespace haptiv
