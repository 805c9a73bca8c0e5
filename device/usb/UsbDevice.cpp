#include "device/usb/UsbDevice.h"

#include <chrono>
#include <thread>
#include <utility>

#include "device/Nonblocking.h"
#include "device/usb/host/BoardClient.h"
#include "device/usb/host/SilenceGuard.h"
#include "device/usb/libusb/UsbFailure.h"
#include "device/usb/libusb/UsbLink.h"

namespace haptiv {

namespace {

constexpr double kLongestUsbPeriod = 0.1;           // [s]
constexpr double kFullSpeedPeriod = 1e-3;           // [s] between two packets at full speed
constexpr std::chrono::milliseconds kLastWord{20};  // that the board is given to brake

constexpr std::chrono::milliseconds kFirstWord{100};  // that it is given to say where it stands

void expectPossible(double period) {
  if (period > 0 && period <= kLongestUsbPeriod) return;
  throw std::runtime_error("a device over USB cannot run with a period of " + std::to_string(period) +
                           " s; choose a rate of 10 Hz or more");
}

}  // namespace

struct UsbDevice::Parts {
  Parts(const DeviceDescription& newDescription, UsbDeviceChoice newChoice)
      : choice(std::move(newChoice)), client(newDescription) {}

  void open(double period);
  void look() noexcept;
  bool isRead() const noexcept;
  void noticeLosses() noexcept;

  UsbDeviceChoice choice;
  usb::BoardClient client;
  std::unique_ptr<usb::UsbLink> link;  // while it is started
  usb::SilenceGuard guard{1e-3};
  usb::StateFrame state;
  DeviceReading reading;
  bool fresh = false;       // a new state since the last write
  bool lossUntold = false;  // to the session, which latches what a reading tells
  bool waits = false;       // after a loss: for the operator to let go of the dead-man
  std::uint64_t lossesSeen = 0;
  std::atomic<std::uint16_t> pressed = 0;
};

void UsbDevice::Parts::open(double period) {
  using namespace usb;
  auto opened = std::make_unique<UsbLink>(boardKind(), choice.serial, client);
  const std::uint64_t statesBefore = client.figures().states;
  client.newest(state);  // of an earlier start
  state = {};
  client.homeNext(choice.home);
  client.setPeriod(period);
  opened->open();
  if (client.form() == FrameForm::packed && period < kFullSpeedPeriod * (1 - 1e-9))
    throw UsbFailure(UsbTrouble::wrongDevice,
                     "the interface board is connected at full speed, which carries 1000 ticks "
                     "per second: choose a rate of 1000 Hz or less, or a port of high speed");
  if (client.phase() == BoardPhase::unhomed && !choice.unhomed)
    throw UsbFailure(UsbTrouble::wrongDevice,
                     "the interface board has not been homed since it was switched on: put the "
                     "arm into its reference pose and home it: haptiv device home --device usb");
  guard = SilenceGuard(period);
  fresh = waits = false;
  lossesSeen = client.losses();
  link = std::move(opened);
  // A servo that began before the first state would take its counts for a jump of the encoders.
  const auto end = std::chrono::steady_clock::now() + kFirstWord;
  while (client.figures().states == statesBefore && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// Takes what is new of the link.
void UsbDevice::Parts::look() noexcept {
  if (client.newest(state)) {
    reading = state.report.reading;
    reading.deviceTime = state.report.time;
    fresh = true;
  }
  reading.connected = isRead() && guard.answers() && state.sequence != 0;
  noticeLosses();
}

bool UsbDevice::Parts::isRead() const noexcept {
  const usb::BoardPhase phase = client.phase();
  return phase == usb::BoardPhase::ready || (choice.unhomed && phase == usb::BoardPhase::unhomed);
}

/// A board that has left and come back within a tick is a loss all the same.
void UsbDevice::Parts::noticeLosses() noexcept {
  const std::uint64_t losses = client.losses();
  if (losses != lossesSeen) {
    waits = lossUntold = true;
    reading.connected = false;
    state = {};
  }
  lossesSeen = losses;
}

UsbDevice::UsbDevice(const DeviceDescription& description, UsbDeviceChoice choice)
    : parts_(std::make_unique<Parts>(description, std::move(choice))) {}

UsbDevice::~UsbDevice() {
  stop();
}

void UsbDevice::start(double period) {
  expectPossible(period);
  if (!parts_->link) parts_->open(period);
}

DeviceReading UsbDevice::read() noexcept {
  if (parts_->link) parts_->look();
  DeviceReading reading = parts_->reading;
  if (std::exchange(parts_->lossUntold, false)) reading.connected = false;
  return reading;
}

void UsbDevice::write(const DeviceCommand& command) noexcept {
  Parts& p = *parts_;
  if (!p.link) return;
  if (!p.fresh) p.look();
  p.guard.tick(std::exchange(p.fresh, false));
  const bool there = p.client.phase() == usb::BoardPhase::ready;
  if (there && p.reading.connected && (p.reading.inputs & kInputDeadMan) == 0) p.waits = false;
  const bool allowed = there && !p.waits;
  const std::uint16_t pressed = p.pressed;
  const DeviceIo io;
  p.client.write(allowed ? p.guard.restrain(command) : DeviceCommand{command.mode}, (pressed & kInputReset) != 0,
                 (pressed & kInputEmergencyStops) != 0);
  p.link->wake();
}

void UsbDevice::stop() {
  Parts& p = *parts_;
  if (!p.link) return;
  const auto end = std::chrono::steady_clock::now() + kLastWord;
  if (!p.client.braked()) write({});
  while (!p.client.braked() && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  p.link.reset();
}

void UsbDevice::press(std::uint16_t inputs) noexcept {
  parts_->pressed = inputs;
}

bool UsbDevice::homed() const {
  return parts_->client.phase() == usb::BoardPhase::ready;
}

void UsbDevice::home(const PoseCounts& counts) {
  if (!parts_->link) throw usb::UsbFailure(usb::UsbTrouble::gone, "start the device before it is homed");
  parts_->link->betweenStreams([this, &counts](usb::UsbHandle& board) {
    usb::setHome(board, counts);
    parts_->client.homed();
  });
}

usb::LinkFigures UsbDevice::figures() const {
  return parts_->client.figures();
}

TimeDistribution UsbDevice::latencies() const {
  return parts_->client.latencies();
}

std::string UsbDevice::serial() const {
  return parts_->link ? parts_->link->serial() : std::string();
}

std::string UsbDevice::trouble() const {
  return parts_->link ? parts_->link->trouble() : std::string();
}

bool UsbDevice::highSpeed() const {
  return parts_->client.form() == usb::FrameForm::full;
}

}  // namespace haptiv
