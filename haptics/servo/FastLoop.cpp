#include "haptics/servo/FastLoop.h"

#include "haptics/realtime/TickGrid.h"
#include "haptics/servo/ServeTick.h"

namespace haptiv {
namespace {

/// Stops the device at the end of the scope. An error in stopping is told, unless another one is on its way.
class Started {
 public:
  Started(HapticDevice& device, double period) : device_(device) { device_.start(period); }
  ~Started() {
    if (stopped_) return;
    try {
      device_.stop();
    } catch (...) {  // the error that ended the run is the one to be told
    }
  }
  Started(const Started&) = delete;
  Started& operator=(const Started&) = delete;
  void stop() {
    stopped_ = true;
    device_.stop();
  }

 private:
  HapticDevice& device_;
  bool stopped_ = false;
};

}  // namespace

std::uint64_t runFast(HapticDevice& device, const DeviceDescription& description, double rate, const HapticScene& scene,
                      std::uint64_t ticks, const std::function<bool(const TickRecord&)>& sink) {
  const HapticTick tick(description, 1 / rate);
  const TickGrid grid(0, rate);
  TickState state;
  Started started(device, 1 / rate);
  std::uint64_t done = 0;
  for (bool wanted = true; wanted && done < ticks; ++done) {
    TickRecord record = serveTick(
        device, tick, [&]() noexcept -> const HapticScene& { return scene; }, state);
    record.tick = done;
    record.time = grid.timeOf(done);
    wanted = sink(record);
  }
  started.stop();
  return done;
}

}  // namespace haptiv
