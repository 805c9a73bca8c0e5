#pragma once

#include <chrono>
#include <thread>

#include "tests/support/usb/VirtualBus.h"

namespace haptiv::test {

/// A virtual bus that goes on by itself, for what waits for answers or runs by the clock: an interval, and a pause of
/// `pause`, for as long as this lives.
class RunningBus {
 public:
  explicit RunningBus(VirtualBus& bus, std::chrono::microseconds pause = std::chrono::milliseconds(1))
      : thread_([&bus, pause](const std::stop_token& stop) {
          while (!stop.stop_requested()) {
            bus.step();
            std::this_thread::sleep_for(pause);
          }
        }) {}

 private:
  std::jthread thread_;
};

}  // namespace haptiv::test
