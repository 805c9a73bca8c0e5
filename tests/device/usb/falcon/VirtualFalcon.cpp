#include "tests/device/usb/falcon/VirtualFalcon.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "device/usb/falcon/FalconStream.h"
#include "device/usb/falcon/SerialPort.h"

namespace haptiv::falcon::test {
namespace {

constexpr std::uint16_t kDtrHigh = 0x0101, kDtrLow = 0x0100;
constexpr int kStepsOfMillisecond = 8;
const HandTarget kPulledOut{true, Vector3(0, 0, 0.2)};

unsigned baudOf(FtdiValue value) {
  return value.value | unsigned{value.index} << 16;
}
unsigned baudOf(unsigned baud) {
  return baudOf(ftdiDivisor(baud));
}

}  // namespace

VirtualFalcon::VirtualFalcon(const DeviceDescription& description, std::size_t firmwareSize)
    : description_(description), arm_(description, description.homeAngles, 1), firmwareSize_(firmwareSize) {}

bool VirtualFalcon::control(std::uint8_t request, std::uint16_t value, std::uint16_t index) {
  switch (static_cast<Ftdi>(request)) {
    case Ftdi::reset:
      if (value == 1) told_.clear();
      return value <= 2;
    case Ftdi::modem:
      if (value == kDtrHigh && baud_ == baudOf(9600u)) {
        stage_ = Stage::asked;
        heard_.clear();
        firmware_.clear();
        homed_ = 0;
      }
      if (value == kDtrHigh && baud_ == baudOf(140'000u) && stage_ == Stage::asked) heard_.clear();
      return value == kDtrHigh || value == kDtrLow || value == 0x0200 || value == 0x0202;
    case Ftdi::baud:
      baud_ = baudOf(FtdiValue{value, index});
      return true;
    case Ftdi::flow:
    case Ftdi::data:
    case Ftdi::latency:
      return true;
  }
  return false;
}

void VirtualFalcon::take(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    if (stage_ == Stage::running)
      takeOfFirmware(byte);
    else
      takeOfLoader(byte);
  }
}

void VirtualFalcon::takeOfLoader(std::uint8_t byte) {
  heard_.push_back(byte);
  if (stage_ == Stage::asked && baud_ == baudOf(9600u)) {
    if (heard_ != std::vector<std::uint8_t>{0x0a, 0x43, 0x0d}) return;
    heard_.clear();
    if (faults_.loaderSilent > 0) {
      --faults_.loaderSilent;
      return;
    }
    if (faults_.longAnswer) told_.push_back(0);
    say(std::array<std::uint8_t, 4>{0x0a, 0x44, 0x2c, 0x0d});
  } else if (stage_ == Stage::asked && baud_ == baudOf(140'000u)) {
    if (byte != 0x41) return;
    if (faults_.longAnswer) told_.push_back(0x13);
    told_.push_back(byte);
    stage_ = Stage::loading;
    heard_.clear();
  } else if (stage_ == Stage::loading && baud_ == baudOf(140'000u)) {
    firmware_.push_back(byte);
    const bool wrong = static_cast<std::ptrdiff_t>(firmware_.size()) - 1 == faults_.echoWrongAt;
    told_.push_back(wrong ? static_cast<std::uint8_t>(byte ^ 1u) : byte);
    if (firmware_.size() == firmwareSize_) {
      stage_ = Stage::running;
      heard_.clear();
    }
  }
}

void VirtualFalcon::takeOfFirmware(std::uint8_t byte) {
  if (faults_.firmwareDead || baud_ != baudOf(1'456'312u)) return;
  if (heard_.empty() && byte != '<') return;
  heard_.push_back(byte);
  if (heard_.size() < kPacketSize) return;
  const auto order = decodeOrder(heard_);
  heard_.clear();
  if (!order) return;
  follow(*order);
  answer();
}

void VirtualFalcon::follow(const Order& order) {
  order_ = order;
  ++orders_;
  DriveDemand demand;
  demand.braked = false;
  demand.mode = DriveMode::torque;
  for (std::size_t i = 0; i < order.motors.size(); ++i) {
    largestMotor_ = std::max(largestMotor_, static_cast<std::int16_t>(std::abs(order.motors[i])));
    demand.setPoints[static_cast<Eigen::Index>(i)] = order.motors[i] / description_.falcon.torqueCounts;
  }
  const HandTarget hand = faults_.operatorHomes && homed_ != kAllHomed ? kPulledOut : hand_;
  for (int i = 0; i < kStepsOfMillisecond; ++i) arm_.advance(demand, hand, 1e-3 / kStepsOfMillisecond);
  for (int i = 0; i < 3 && order.homing; ++i) {
    if (faults_.homesByItself || arm_.angles()[i] > kHomingAngle) homed_ |= static_cast<std::uint8_t>(1u << i);
  }
  homed_ &= static_cast<std::uint8_t>(order.homing ? ~faults_.unhomed : 0);
}

void VirtualFalcon::answer() {
  if (faults_.answersLost > 0) {
    --faults_.answersLost;
    return;
  }
  State state;
  const JointVector countsPerRadian = description_.drives.countsPerRadian();
  for (int i = 0; i < 3; ++i) {
    const double angle = arm_.angles()[i] - ((homed_ >> i & 1u) != 0 ? description_.falcon.homedAngle : 0.2 * i);
    state.counts[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(std::lround(angle * countsPerRadian[i]));
  }
  state.homed = homed_;
  state.buttons = buttons_;
  Packet packet = encode(state);
  if (faults_.answersDamaged > 0) {
    --faults_.answersDamaged;
    packet[5] = 0xFF;
  }
  say(packet);
}

std::vector<std::uint8_t> VirtualFalcon::tell() {
  std::vector<std::uint8_t> packet = {0x01, 0x60};  // modem and line status of a chip at rest
  const auto count = static_cast<std::ptrdiff_t>(std::min(told_.size(), Stream::kUsbPacket - Stream::kStatus));
  packet.insert(packet.end(), told_.begin(), told_.begin() + count);
  told_.erase(told_.begin(), told_.begin() + count);
  return packet;
}

}  // namespace haptiv::falcon::test
