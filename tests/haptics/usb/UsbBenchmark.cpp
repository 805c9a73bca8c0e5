// How fast the loop over USB closes, and what it costs, by the wall clock: real libusb above a virtual bus that a
// thread moves, a board with a simulated arm behind it, the servo thread with the whole tick. What the kernel and the
// wire take is not in it.
//
//     usb_benchmark [SECONDS [REPETITIONS]]
#include <pthread.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "device/usb/UsbDevice.h"
#include "haptics/realtime/MonotonicClock.h"
#include "haptics/servo/ServoLoop.h"
#include "tests/device/usb/bench/BoardOnUsb.h"
#include "tests/haptics/usb/ThreadTimes.h"
#include "tests/haptics/usb/WallBeforeHome.h"
#include "tests/support/usb/ShimTime.h"
#include "tests/support/usb/VirtualBus.h"

namespace haptiv::test {
namespace {

/// Moves a bus by the wall clock, and the operator's hand with it.
class BusClock {
 public:
  BusClock(VirtualBus& bus, BoardOnUsb& board, HandSource& hand, UsbSpeed speed)
      : thread_([this, &bus, &board, &hand, speed] { run(bus, board, hand, speed); }) {
    makeRealtime(thread_);
    pthread_setname_np(thread_.native_handle(), "bench-bus");
  }
  ~BusClock() {
    running_ = false;
    thread_.join();
  }

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
    }
  }

  std::atomic<bool> running_ = true;
  std::thread thread_;
};

/// Who has taken how much of a core. The link's own time is that of its thread without what the bench does on it.
struct Shares {
  double servo = 0, link = 0;                ///< the host
  double answers = 0, bus = 0, theRest = 0;  ///< the bench: in the host's system calls, its bus and arm, what is left

  double host() const { return servo + link; }
  double all() const { return host() + answers + bus + theRest; }
};

class ShareMeter {
 public:
  Shares shares() const {
    const double passed = 1e-9 * static_cast<double>(monotonicNow() - start_);
    Shares taken;
    taken.answers = (ShimTime::taken() - answers_) / passed;
    for (const auto& [name, time] : threadTimes()) {
      const auto before = times_.find(name);
      const double share = (time - (before == times_.end() ? 0 : before->second)) / passed;
      (name == "haptiv-servo" ? taken.servo
       : name == "haptiv-usb" ? taken.link
       : name == "bench-bus"  ? taken.bus
                              : taken.theRest) += share;
    }
    taken.link -= taken.answers;
    return taken;
  }

 private:
  std::int64_t start_ = monotonicNow();
  double answers_ = ShimTime::taken();
  std::map<std::string, double> times_ = threadTimes();
};

void print(const Shares& shares) {
  std::printf(
      "    host %.1f %% of a core: servo %.1f %%, link %.1f %%; the bench: answers in the link's system calls %.1f %%, "
      "bus and arm %.1f %%, the rest %.1f %%; all together %.1f %%\n",
      100 * shares.host(), 100 * shares.servo, 100 * shares.link, 100 * shares.answers, 100 * shares.bus,
      100 * shares.theRest, 100 * shares.all());
}

void measure(double rate, UsbSpeed speed, double seconds) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const WallBeforeHome wall(description);
  const auto hand = wall.pushedBy(20);
  VirtualBus bus(VirtualBus::Clock::wall);
  const auto board = std::make_shared<BoardOnUsb>(description, "BENCH-1", speed);
  bus.plug(board);
  UsbDevice device(description, {"BENCH-1", board->countsHere(), false});
  ServoSeams seams(rate);
  seams.scene.write(std::make_shared<const HapticScene>(wall.scene()));
  ServoLoop loop(device, description, {rate}, seams);
  BusClock clock(bus, *board, *hand, speed);
  loop.start();
  const ShareMeter meter;
  const std::int64_t start = monotonicNow();
  std::uint64_t ticks = 0, stale = 0;
  TickRecord last;
  while (monotonicNow() - start < static_cast<std::int64_t>(1e9 * seconds)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    seams.log.drain([&](const TickRecord& record) {
      if (ticks > 0 && record.reading.deviceTime == last.reading.deviceTime) ++stale;
      last = record;
      ++ticks;
    });
  }
  const double passed = 1e-9 * static_cast<double>(monotonicNow() - start);
  const Shares shares = meter.shares();
  loop.stop();
  const TimeDistribution latencies = device.latencies();
  const usb::LinkFigures figures = device.figures();
  std::printf(
      "%5.0f Hz %s speed: %llu ticks, %u missed, %llu without a new state; command to echo: median %.0f us, p99 %.0f "
      "us; "
      "%.0f states/s, %llu commands, %llu skipped, %llu missing; depth %.2f mm, faults: %s\n",
      rate, speed == UsbSpeed::high ? "high" : "full", static_cast<unsigned long long>(ticks), last.missedTicks,
      static_cast<unsigned long long>(stale), 1e-3 * static_cast<double>(latencies.quantile(0.5)),
      1e-3 * static_cast<double>(latencies.quantile(0.99)), static_cast<double>(figures.states) / passed,
      static_cast<unsigned long long>(figures.sent), static_cast<unsigned long long>(figures.skipped),
      static_cast<unsigned long long>(figures.missing), 1e3 * wall.depthOf(last.position),
      faultList(last.faults).c_str());
  print(shares);
  std::fflush(stdout);
}

}  // namespace
}  // namespace haptiv::test

int main(int argc, char** argv) {
  using haptiv::test::measure;
  using haptiv::test::UsbSpeed;
  haptiv::test::ShimTime::count();
  const double seconds = argc > 1 ? std::atof(argv[1]) : 20;
  for (int left = argc > 2 ? std::atoi(argv[2]) : 1; left > 0; --left) {
    measure(1000, UsbSpeed::high, seconds);
    measure(4000, UsbSpeed::high, seconds);
    measure(1000, UsbSpeed::full, seconds);
  }
}
