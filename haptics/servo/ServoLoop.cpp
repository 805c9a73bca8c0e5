#include "haptics/servo/ServoLoop.h"

#include <pthread.h>

#include <algorithm>
#include <ctime>
#include <limits>
#include <stdexcept>

#include "haptics/realtime/MonotonicClock.h"
#include "haptics/servo/ServeTick.h"

namespace haptiv {
namespace {

/// A duration [ns] for the record; one of more than two seconds (the machine slept) is told as two seconds.
std::int32_t shortDuration(std::int64_t duration) noexcept {
  constexpr std::int64_t kLongest = std::numeric_limits<std::int32_t>::max();
  return static_cast<std::int32_t>(std::min(duration, kLongest));
}

/// What a thread's clock has counted of the time since `start` [ns].
double shareOf(clockid_t clock, std::int64_t start) noexcept {
  timespec used{};
  if (clock_gettime(clock, &used) != 0) return 0;
  const double seconds = static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
  return seconds / std::max(1e-9, 1e-9 * static_cast<double>(monotonicNow() - start));
}

}  // namespace

ServoLoop::ServoLoop(HapticDevice& device, const DeviceDescription& description, const ServoPace& pace,
                     ServoSeams& seams)
    : device_(device), tick_(description, 1 / pace.rate), pace_(pace), seams_(seams) {}

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
  device_.start(1 / pace_.rate);
  awake_.emplace();
  running_ = true;
  startedAt_ = monotonicNow();
  try {
    thread_ = std::thread([this] { run(); });
  } catch (...) {
    running_ = false;
    awake_.reset();
    device_.stop();
    throw;
  }
  scheduling_ = makeRealtime(thread_);
  pthread_setname_np(thread_.native_handle(), "haptiv-servo");  // for `top -H`
  scheduling_.processorAwake = awake_->isKept();
  return scheduling_;
}

void ServoLoop::stop() {
  if (!thread_.joinable()) return;
  running_ = false;
  thread_.join();
  awake_.reset();
  device_.stop();
}

double ServoLoop::processorShare() const {
  if (!thread_.joinable()) return lastShare_;
  clockid_t clock = 0;
  // Only the owner joins the thread, and is here: it is there still.
  if (pthread_getcpuclockid(const_cast<std::thread&>(thread_).native_handle(), &clock) != 0) return 0;
  return shareOf(clock, startedAt_);
}

void ServoLoop::run() noexcept {
  TickState state;
  std::uint32_t missed = 0;
  const std::int64_t spin = pace_.spinNs();
  TickGrid grid(monotonicNow(), pace_.rate);
  while (running_) {
    sleepThenSpin(grid.deadline(), spin);
    const std::int64_t done = serve(grid, missed, state);
    missed += grid.advance(done);
  }
  lastShare_ = shareOf(CLOCK_THREAD_CPUTIME_ID, startedAt_);
}

std::int64_t ServoLoop::serve(const TickGrid& grid, std::uint32_t missed,
                              TickState& state) noexcept HAPTIV_NONBLOCKING {
  const auto newestScene = [this]() noexcept -> const HapticScene& {
    seams_.scene.update();
    return *seams_.scene.read();
  };
  const std::int64_t woke = monotonicNow();
  TickRecord record = serveTick(device_, tick_, newestScene, state, missed);
  record.tick = grid.index();
  record.time = woke - grid.timeOf(0);
  record.wakeLateness = shortDuration(woke - grid.deadline());
  record.computeTime = shortDuration(monotonicNow() - woke);
  seams_.log.push(record);
  seams_.display.write(record);
  seams_.wakeUps.add(woke - grid.deadline());
  const std::int64_t done = monotonicNow();
  seams_.ticks.add(done - woke);
  return done;
}

}  // namespace haptiv
