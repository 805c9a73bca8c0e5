#include "haptics/ServoLoop.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "haptics/ServeTick.h"
#include "haptics/realtime/MonotonicClock.h"
#include "haptics/realtime/TickGrid.h"

namespace haptiv {
namespace {

/// A duration [ns] for the record; one of more than two seconds (the machine slept) is told as two seconds.
std::int32_t shortDuration(std::int64_t duration) noexcept {
  constexpr std::int64_t kLongest = std::numeric_limits<std::int32_t>::max();
  return static_cast<std::int32_t>(std::min(duration, kLongest));
}

}  // namespace

ServoLoop::ServoLoop(HapticDevice& device, const DeviceDescription& description, double rate, ServoSeams& seams)
    : device_(device), tick_(description, 1 / rate), rate_(rate), seams_(seams) {}

ServoLoop::~ServoLoop() {
  try {
    stop();
  } catch (...) {  // a destructor cannot tell; whoever wants to know calls stop
  }
}

Scheduling ServoLoop::start() {
  if (thread_.joinable()) return scheduling_;
  seams_.scene.update();  // no servo runs yet: this thread is the reader
  if (seams_.scene.read() == nullptr) throw std::logic_error("ServoLoop: write a scene to the seam before starting");
  device_.start(1 / rate_);
  running_ = true;
  try {
    thread_ = std::thread([this] { run(); });
  } catch (...) {
    running_ = false;
    device_.stop();
    throw;
  }
  scheduling_ = makeRealtime(thread_);
  return scheduling_;
}

void ServoLoop::stop() {
  if (!thread_.joinable()) return;
  running_ = false;
  thread_.join();
  device_.stop();
}

void ServoLoop::run() noexcept {
  TickState state;
  std::uint32_t missed = 0;
  const std::int64_t start = monotonicNow();
  const auto newestScene = [this]() noexcept -> const HapticScene& {
    seams_.scene.update();
    return *seams_.scene.read();
  };
  for (TickGrid grid(start, rate_); running_; missed += grid.advance(monotonicNow())) {
    sleepUntil(grid.deadline());
    const std::int64_t woke = monotonicNow();
    TickRecord record = serveTick(device_, tick_, newestScene, state, missed);
    record.tick = grid.index();
    record.time = woke - start;
    record.wakeLateness = shortDuration(woke - grid.deadline());
    record.computeTime = shortDuration(monotonicNow() - woke);
    seams_.log.push(record);
    seams_.display.write(record);
  }
}

}  // namespace haptiv
