#include "device/board/Board.h"

#include <algorithm>

#include "device/board/WrappingSum.h"

namespace haptiv {

namespace {

/// Cuts set-points to +-limit; true if one had to be.
bool cut(JointVector& setPoints, const JointVector& limit) noexcept {
  const JointVector within = setPoints.cwiseMin(limit).cwiseMax(-limit);
  const bool changed = within != setPoints;
  setPoints = within;
  return changed;
}

}  // namespace

Board::Board(const BoardSettings& settings) noexcept : settings_(settings), thresholds_(settings.thresholds) {}

std::uint32_t Board::causes(const BoardInputs& inputs, bool wasDriving) noexcept {
  std::uint32_t found = kNoTrip;
  const std::uint16_t tooFast = shutOff_.count(now_, inputs.encoderCounts);
  const std::uint16_t broken = inputs.encoderFaults | shutOff_.jumps();
  if (tooFast != 0) found |= kTripOverspeed | tripJoints(tooFast);
  if (broken != 0) found |= kTripEncoder | tripJoints(broken);
  if ((inputs.buttons & kInputEmergencyStops) != 0) found |= kTripEmergencyStop;
  if (!inputs.powerGood) found |= kTripPower;
  if (wasDriving && !fed()) found |= kTripWatchdog;
  if (isDeadManIgnored(inputs, wasDriving)) found |= kTripDeadMan;
  return found;
}

bool Board::isDeadManIgnored(const BoardInputs& inputs, bool wasDriving) noexcept {
  const bool released = (inputs.buttons & kInputDeadMan) == 0;
  if (wasDriving && released) {
    releasedAt_ = now_;
    awaitsHost_ = true;
  }
  if (!released || !command_.drive.enabled) awaitsHost_ = false;
  return awaitsHost_ && now_ - releasedAt_ > thresholds_.watchdogTime;
}

void Board::advance(std::int64_t now, const BoardInputs& inputs) noexcept {
  const bool wasDriving = driving();
  now_ = started_ ? std::max(now_, now) : now;
  if (!started_) shutOff_.begin(thresholds_, now_, inputs.encoderCounts);
  started_ = true;
  latch_.update(causes(inputs, wasDriving), inputs.buttons, command_.reset && fed());
  inputs_ = inputs;
}

Acceptance Board::accept(const BoardCommand& command) noexcept {
  // A host that was gone begins its sequence anew: while nobody feeds the watchdog, the drives brake anyway.
  if (fed() && static_cast<std::int32_t>(command.sequence - command_.sequence) <= 0) {
    ++counters_.outOfOrder;
    return Acceptance::outOfOrder;
  }
  if (everFed_ && command.heartbeat == command_.heartbeat) {
    ++counters_.sameHeartbeat;
    return Acceptance::sameHeartbeat;
  }
  if (!command.drive.jointRates.allFinite() || !command.drive.jointTorques.allFinite()) {
    ++counters_.notFinite;
    latch_.trip(kTripCommand);
    return Acceptance::notFinite;
  }
  if (command.trip) latch_.trip(kTripHost);
  command_ = command;
  const bool cutRates = cut(command_.drive.jointRates, settings_.rateLimit);
  const bool cutTorques = cut(command_.drive.jointTorques, settings_.torqueLimit);
  if (cutRates || cutTorques) ++counters_.clamped;
  ++counters_.accepted;
  fedAt_ = now_;
  everFed_ = true;
  return Acceptance::accepted;
}

DriveDemand Board::demand() const noexcept {
  if (!driving()) return {};
  const DeviceCommand& drive = command_.drive;
  return {false, drive.mode, drive.mode == DriveMode::torque ? drive.jointTorques : drive.jointRates};
}

BoardReport Board::report() const noexcept {
  BoardReport report;
  for (int i = 0; i < kJointCount; ++i)
    report.reading.encoderCounts[i] = sumWrapping(inputs_.encoderCounts[i], countOffsets_[i]);
  report.reading.sensorCounts = inputs_.sensorCounts;
  report.reading.inputs = inputs_.buttons;
  report.reading.trips = latch_.trips();
  report.time = now_;
  report.lastSequence = command_.sequence;
  if (fed()) report.watchdogLeft = static_cast<std::uint32_t>(fedAt_ + thresholds_.watchdogTime - now_);
  report.driving = driving();
  report.armed = latch_.armed();
  report.counters = counters_;
  return report;
}

bool Board::configure(const CircuitThresholds& thresholds) noexcept {
  if (driving() || !noLooser(thresholds, settings_.thresholds)) return false;
  thresholds_ = thresholds;
  shutOff_.begin(thresholds_, now_, inputs_.encoderCounts);
  return true;
}

bool Board::home(const std::array<std::int32_t, kJointCount>& counts) noexcept {
  if (driving()) return false;
  for (int i = 0; i < kJointCount; ++i)
    countOffsets_[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(counts[i]) -
                                                 static_cast<std::uint32_t>(inputs_.encoderCounts[i]));
  homed_ = true;
  return true;
}

}  // namespace haptiv
