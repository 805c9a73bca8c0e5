#include "device/usb/falcon/FalconDevice.h"

#include <atomic>
#include <stdexcept>
#include <thread>
#include <utility>

#include "device/Nonblocking.h"
#include "device/usb/falcon/FalconFirmware.h"
#include "device/usb/falcon/FalconPort.h"
#include "device/usb/host/SilenceGuard.h"
#include "device/usb/libusb/UsbLink.h"

namespace haptiv {
namespace {

using namespace std::chrono_literals;

constexpr double kShortestFalconPeriod = 1e-3, kLongestFalconPeriod = 0.1;  // [s]
constexpr std::chrono::milliseconds kLastFalconWord = 20ms;                 // to say that no torque is wanted
constexpr std::chrono::milliseconds kLook = 5ms;

void expectFalconPeriod(double period) {
  if (period >= kShortestFalconPeriod * (1 - 1e-9) && period <= kLongestFalconPeriod) return;
  throw std::runtime_error("a Falcon cannot run with a period of " + std::to_string(period) +
                           " s: it answers 1000 times a second; choose a rate of 10 to 1000 Hz");
}

falcon::Client::Firmware firmwareOf(const FalconChoice& choice) {
  return [path = choice.firmware.empty() ? falcon::firmwarePath() : choice.firmware] {
    return falcon::readFirmware(path);
  };
}

}  // namespace

struct FalconDevice::Parts {
  Parts(const DeviceDescription& description, FalconChoice newChoice)
      : choice(std::move(newChoice)), logic(description), client(description, firmwareOf(choice)) {
    seen.state = {};
    reading = logic.reading(seen.state, falcon::Homing::homed);
    reading.connected = false;
  }

  void waitUntilHomed();

  FalconChoice choice;
  falcon::Logic logic;
  falcon::Client client;
  std::unique_ptr<usb::UsbLink> link;  // while it is started
  usb::SilenceGuard guard{kShortestFalconPeriod};
  falcon::Seen seen;
  DeviceReading reading;
  bool fresh = false;                      // a new state since the last write
  std::atomic<std::uint16_t> pressed = 0;  // at the host
};

void FalconDevice::Parts::waitUntilHomed() {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + choice.homingTime;
  for (bool told = false; !(client.newest(seen) && seen.homing == falcon::Homing::homed);) {
    if (!client.isThere()) throw std::runtime_error("the Falcon has left while it was homed: " + link->trouble());
    if (choice.cancelled && choice.cancelled()) throw std::runtime_error("the Falcon was not homed: cancelled");
    if (!told && seen.number > 0 && choice.tell)
      choice.tell("Falcon: pull the grip all the way out, then push it in, until its light is blue");
    told = told || seen.number > 0;
    if (Clock::now() >= end)
      throw std::runtime_error(
          "the Falcon has not been homed: start again, pull the grip all the way out and push it in");
    std::this_thread::sleep_for(kLook);
  }
  reading = logic.reading(seen.state, seen.homing);
}

FalconDevice::FalconDevice(const DeviceDescription& description, FalconChoice choice) {
  if (!description.delta || description.type != DeviceType::impedance)
    throw std::runtime_error("a Falcon cannot be the arm " + description.name +
                             ": let the scene's HapticDevice name the description falcon");
  parts_ = std::make_unique<Parts>(description, std::move(choice));
}

FalconDevice::~FalconDevice() {
  stop();
}

void FalconDevice::start(double period) {
  expectFalconPeriod(period);
  Parts& p = *parts_;
  if (p.link) return;
  p.link = std::make_unique<usb::UsbLink>(falcon::usbKind(), p.choice.which, p.client);
  try {
    p.link->open();
    p.waitUntilHomed();
  } catch (...) {
    p.link.reset();
    throw;
  }
  p.guard = usb::SilenceGuard(period);
  p.fresh = false;
}

DeviceReading FalconDevice::read() noexcept {
  Parts& p = *parts_;
  if (!p.link) return p.reading;
  if (p.client.newest(p.seen)) {
    p.reading = p.logic.reading(p.seen.state, p.seen.homing);
    p.fresh = true;
  }
  if (!p.client.isThere() || !p.guard.answers()) p.reading.connected = false;
  DeviceReading reading = p.reading;
  reading.inputs |= p.pressed & (kInputEmergencyStops | kInputReset);
  return reading;
}

void FalconDevice::write(const DeviceCommand& command) noexcept {
  Parts& p = *parts_;
  if (!p.link) return;
  p.guard.tick(std::exchange(p.fresh, false));
  const bool stopped = (p.pressed & kInputEmergencyStops) != 0;
  const DeviceIo io;
  p.client.write(p.guard.restrain(stopped ? DeviceCommand{} : command));
  p.link->wake();
}

void FalconDevice::stop() {
  Parts& p = *parts_;
  if (!p.link) return;
  p.client.write({});
  p.link->wake();
  const auto end = std::chrono::steady_clock::now() + kLastFalconWord;
  while (!p.client.isStill() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(1ms);
  p.link.reset();
}

void FalconDevice::press(std::uint16_t inputs) noexcept {
  parts_->pressed = inputs;
}

falcon::Figures FalconDevice::figures() const {
  return parts_->client.figures();
}

}  // namespace haptiv
