#include "device/simulated/SimulatedDevice.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "device/Encoder.h"
#include "device/board/Board.h"
#include "device/simulated/FaultySensors.h"
#include "device/simulated/SimulatedArm.h"

namespace haptiv {
namespace {

constexpr double kLongestPeriod = 0.1;

/// Rounded to encoder counts, so that the arm stands where its encoders say.
JointVector onCounts(const DeviceDescription& description, JointVector angles) {
  const JointVector countsPerRadian = description.drives.countsPerRadian();
  for (int i = 0; i < kJointCount; ++i) {
    if (!std::isfinite(angles[i]))
      throw std::runtime_error("start angle of joint " + std::to_string(i + 1) + " is not finite; give one in rad");
    const Encoder encoder(countsPerRadian[i], description.encoders.zero[i]);
    angles[i] = encoder.angle(encoder.count(angles[i]));
  }
  return angles;
}

/// All that a start begins anew.
struct Running {
  Running(const DeviceDescription& description, const JointVector& start, std::uint64_t seed)
      : arm(description, start, seed), board(boardSettings(description)), sensors(description.sensor) {}

  SimulatedArm arm;
  Board board;
  FaultySensors sensors;
  std::int64_t ticks = 0;
  std::uint32_t commands = 0;  // sent to the board
};

}  // namespace

struct SimulatedDevice::Parts {
  Parts(const DeviceDescription& newDescription, const JointVector& start, std::unique_ptr<HandSource> hand,
        std::uint64_t newSeed)
      : description(newDescription),
        source(std::move(hand)),
        seed(newSeed),
        startAngles(onCounts(description, start)),
        now(description, startAngles, seed) {
    begin();
  }

  void begin();
  void send(const DeviceCommand& command) noexcept;
  void advance(const DeviceCommand& command) noexcept;
  void tell(double time, std::uint16_t buttons) noexcept;

  DeviceDescription description;
  std::unique_ptr<HandSource> source;
  std::uint64_t seed;
  JointVector startAngles;
  Running now;
  InjectedFaults faults;
  DeviceReading reading;
  bool running = false;
  double period = 0;
};

void SimulatedDevice::Parts::begin() {
  now = Running(description, startAngles, seed);
  tell(0, 0);
}

/// What the wires say goes to the board, and what the board says to the host, as far as they are whole.
void SimulatedDevice::Parts::tell(double time, std::uint16_t buttons) noexcept {
  BoardInputs inputs = now.arm.measure();
  inputs.buttons = buttons;
  inputs = now.sensors.falsify(inputs, faults);
  if (faults.boardFrozen) return;
  now.board.advance(std::llround(1e6 * time), inputs);
  if (!faults.disconnected) reading = now.board.report().reading;
  reading.connected = !faults.disconnected;
}

void SimulatedDevice::Parts::send(const DeviceCommand& command) noexcept {
  if (faults.disconnected || faults.hostSilent || faults.boardFrozen) return;
  ++now.commands;
  now.board.accept({now.commands, now.commands, command});
}

void SimulatedDevice::Parts::advance(const DeviceCommand& command) noexcept {
  const double time = static_cast<double>(now.ticks) * period;
  const HandTarget target = source ? source->at(time) : HandTarget{};
  send(command);
  const int steps = static_cast<int>(std::ceil(period / SimulatedArm::kLongestStep * (1 - 1e-12)));
  for (int i = 1; i <= steps; ++i) {
    const DriveDemand demand = faults.boardFrozen ? DriveDemand{} : now.board.demand();
    now.arm.advance(demand, target, period / steps, faults.motorDead);
    if (i < steps) tell(time + i * period / steps, target.inputs);
  }
  ++now.ticks;
  tell(static_cast<double>(now.ticks) * period, target.inputs);
}

SimulatedDevice::SimulatedDevice(const DeviceDescription& description, const JointVector& start,
                                 std::unique_ptr<HandSource> hand, std::uint64_t seed)
    : parts_(std::make_unique<Parts>(description, start, std::move(hand), seed)) {}

SimulatedDevice::~SimulatedDevice() = default;

void SimulatedDevice::start(double period) {
  if (!(period > 0 && period <= kLongestPeriod)) {
    throw std::runtime_error("the simulated device cannot run with a period of " + std::to_string(period) +
                             " s; choose a rate of 10 Hz or more");
  }
  parts_->period = period;
  parts_->begin();
  parts_->running = true;
}

DeviceReading SimulatedDevice::read() noexcept {
  return parts_->reading;
}

void SimulatedDevice::write(const DeviceCommand& command) noexcept {
  if (parts_->running) parts_->advance(command);
}

void SimulatedDevice::stop() {
  parts_->running = false;
}

void SimulatedDevice::home(const PoseCounts& counts) {
  if (!parts_->now.board.home(counts))
    throw std::runtime_error("the drives are on; release the dead-man's button or end the session, then home");
  parts_->reading = parts_->now.board.report().reading;
}

void SimulatedDevice::inject(const InjectedFaults& faults) noexcept {
  parts_->faults = faults;
}

SimulatedDevice::Truth SimulatedDevice::truth() const noexcept {
  const SimulatedArm& arm = parts_->now.arm;
  return {arm.angles(), arm.rates(), arm.torques(), arm.handWrench(), !parts_->now.board.demand().braked};
}

}  // namespace haptiv
