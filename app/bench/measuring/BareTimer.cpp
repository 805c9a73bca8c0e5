#include "app/bench/measuring/BareTimer.h"

#include "haptics/realtime/MonotonicClock.h"
#include "haptics/realtime/RealtimeThread.h"
#include "haptics/realtime/TickGrid.h"

namespace haptiv {

BareTimer::BareTimer(const ServoPace& pace) : pace_(pace), thread_([this] { run(); }) {
  makeRealtime(thread_);
}

BareTimer::~BareTimer() {
  running_ = false;
  thread_.join();
}

void BareTimer::run() noexcept {
  TickGrid grid(monotonicNow(), pace_.rate);
  while (running_) {
    sleepThenSpin(grid.deadline(), pace_.spinNs());
    missed_ += grid.advance(monotonicNow());
    ticks_ = grid.index();
  }
}

}  // namespace haptiv
