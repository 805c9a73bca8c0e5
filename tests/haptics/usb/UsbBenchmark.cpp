// How fast the loop over USB closes, by the wall clock: real libusb above a virtual bus that a thread moves, a board
// with a simulated arm behind it, the servo thread with the whole tick. What the kernel and the wire take is not in it.
//
//     usb_benchmark [SECONDS]
#include <sys/resource.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "device/usb/UsbDevice.h"
#include "haptics/realtime/MonotonicClock.h"
#include "haptics/servo/ServoLoop.h"
#include "tests/device/usb/bench/BoardOnUsb.h"
#include "tests/haptics/usb/WallBeforeHome.h"
#include "tests/support/usb/VirtualBus.h"

namespace haptiv::test {
namespace {

double processorTime(int who) {
  rusage usage{};
  getrusage(who, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Moves a bus by the wall clock, and the operator's hand with it.
class BusClock {
 public:
  BusClock(VirtualBus& bus, BoardOnUsb& board, HandSource& hand, UsbSpeed speed)
      : thread_([this, &bus, &board, &hand, speed] { run(bus, board, hand, speed); }) {
    makeRealtime(thread_);
  }
  ~BusClock() {
    running_ = false;
    thread_.join();
  }
  double processorTimeTaken() const { return taken_; }

 private:
  void run(VirtualBus& bus, BoardOnUsb& board, HandSource& hand, UsbSpeed speed) {
    TickGrid grid(monotonicNow(), speed == UsbSpeed::high ? 8000 : 1000);
    const std::int64_t start = monotonicNow();
    while (running_) {
      sleepThenSpin(grid.deadline(), 0);
      const double time = 1e-9 * static_cast<double>(monotonicNow() - start);
      board.hand = hand.at(time);
      board.buttons = time < 0.2 ? std::uint16_t{0} : board.hand.inputs;
      bus.step();
      grid.advance(monotonicNow());
      taken_ = processorTime(RUSAGE_THREAD);
    }
  }

  std::atomic<bool> running_ = true;
  std::atomic<double> taken_ = 0;
  std::thread thread_;
};

void measure(double rate, UsbSpeed speed, double seconds) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const WallBeforeHome wall(description);
  const auto hand = wall.pushedBy(20);
  VirtualBus bus;
  const auto board = std::make_shared<BoardOnUsb>(description, "BENCH-1", speed);
  bus.plug(board);
  UsbDevice device(description, {"BENCH-1", board->countsHere(), false});
  ServoSeams seams(rate);
  seams.scene.write(std::make_shared<const HapticScene>(wall.scene()));
  ServoLoop loop(device, description, {rate}, seams);
  BusClock clock(bus, *board, *hand, speed);
  loop.start();
  const double before = processorTime(RUSAGE_SELF) - clock.processorTimeTaken();
  const std::int64_t start = monotonicNow();
  std::uint64_t ticks = 0;
  TickRecord last;
  while (monotonicNow() - start < static_cast<std::int64_t>(1e9 * seconds)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    seams.log.drain([&](const TickRecord& record) {
      last = record;
      ++ticks;
    });
  }
  const double passed = 1e-9 * static_cast<double>(monotonicNow() - start);
  const double host = processorTime(RUSAGE_SELF) - clock.processorTimeTaken() - before;
  const double servo = loop.processorShare();
  loop.stop();
  const TimeDistribution latencies = device.latencies();
  const usb::LinkFigures figures = device.figures();
  std::printf(
      "%5.0f Hz %s speed: %llu ticks, %u missed; command to echo: median %.0f us, p99 %.0f us; "
      "host %.1f %% of a core, of it servo %.1f %%; %.0f states/s, %llu commands, %llu skipped; depth %.2f mm, "
      "faults: %s\n",
      rate, speed == UsbSpeed::high ? "high" : "full", static_cast<unsigned long long>(ticks), last.missedTicks,
      1e-3 * static_cast<double>(latencies.quantile(0.5)), 1e-3 * static_cast<double>(latencies.quantile(0.99)),
      100 * host / passed, 100 * servo, static_cast<double>(figures.states) / passed,
      static_cast<unsigned long long>(figures.sent), static_cast<unsigned long long>(figures.skipped),
      1e3 * wall.depthOf(last.position), faultList(last.faults).c_str());
  std::fflush(stdout);
}

}  // namespace
}  // namespace haptiv::test

int main(int argc, char** argv) {
  using haptiv::test::measure;
  using haptiv::test::UsbSpeed;
  const double seconds = argc > 1 ? std::atof(argv[1]) : 20;
  measure(1000, UsbSpeed::high, seconds);
  measure(4000, UsbSpeed::high, seconds);
  measure(1000, UsbSpeed::full, seconds);
}
