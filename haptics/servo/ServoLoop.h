#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <thread>

#include "device/HapticDevice.h"
#include "device/realtime/TripleBuffer.h"
#include "haptics/realtime/AwakeProcessor.h"
#include "haptics/realtime/RealtimeThread.h"
#include "haptics/realtime/RecordRing.h"
#include "haptics/realtime/TickGrid.h"
#include "device/realtime/TimeHistogram.h"
#include "haptics/servo/ServoPace.h"
#include "haptics/tick/HapticTick.h"

namespace haptiv {

/// What crosses between the servo thread and the others; nothing else does.
struct ServoSeams {
  /// @param rate  of the servo [Hz]; the ring to the log holds 6 s of it
  explicit ServoSeams(double rate) : log(recordsToHold(rate)) {}

  TripleBuffer<std::shared_ptr<const HapticScene>> scene;  ///< GUI -> servo: newest valid scene
  TripleBuffer<TickRecord> display;                        ///< servo -> GUI: newest tick
  RecordRing<TickRecord> log;                              ///< servo -> log writer: every tick
  TimeHistogram wakeUps;                                   ///< servo -> GUI: how late after its deadline it woke
  TimeHistogram ticks;  ///< servo -> GUI: from there until all of the tick was done, the seams written too
};

/// The servo thread: wakes on absolute deadlines, reads the device, runs the tick, writes the device.
///
/// On an overrun it skips to the next grid point and counts the missed ticks; it never catches up.
/// Construct and destroy on the thread that owns the session; a scene must have been written to the seam first.
class ServoLoop {
 public:
  ServoLoop(HapticDevice& device, const DeviceDescription& description, const ServoPace& pace, ServoSeams& seams);
  ~ServoLoop();
  ServoLoop(const ServoLoop&) = delete;
  ServoLoop& operator=(const ServoLoop&) = delete;

  /// Starts the device and the thread. Throws what HapticDevice::start throws, std::logic_error where no scene was
  /// written to the seam, and nothing changes where it runs already.
  Scheduling start();
  /// Stops thread and device; safe to call twice.
  void stop();
  /// Part of one processor that the servo's thread has taken since it was started, 0 to 1; a simulated device's
  /// reckoning is in it. 0 before the first start.
  double processorShare() const;

 private:
  void run() noexcept;
  /// All that happens between two sleeps. Returns when it was done [ns].
  std::int64_t serve(const TickGrid& grid, std::uint32_t missed, TickState& state) noexcept HAPTIV_NONBLOCKING;

  HapticDevice& device_;
  HapticTick tick_;
  ServoPace pace_;
  Scheduling scheduling_;
  std::optional<AwakeProcessor> awake_;  ///< while the thread runs
  ServoSeams& seams_;
  std::atomic<bool> running_ = false;
  std::thread thread_;
  std::int64_t startedAt_ = 0;  ///< [ns]
  double lastShare_ = 0;        ///< of the run that has ended; the thread writes it, and is then joined
};

}  // namespace haptiv
