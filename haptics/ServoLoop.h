#pragma once

#include <atomic>
#include <memory>
#include <thread>

#include "device/HapticDevice.h"
#include "haptics/HapticTick.h"
#include "haptics/realtime/RealtimeThread.h"
#include "haptics/realtime/RecordRing.h"
#include "device/realtime/TripleBuffer.h"

namespace haptiv {

/// What crosses between the servo thread and the others; nothing else does.
struct ServoSeams {
  TripleBuffer<std::shared_ptr<const HapticScene>> scene;  ///< GUI -> servo: newest valid scene
  TripleBuffer<TickRecord> display;                        ///< servo -> GUI: newest tick
  RecordRing<TickRecord> log;                              ///< servo -> log writer: every tick
};

/// The servo thread: wakes on absolute deadlines, reads the device, runs the tick, writes the device.
///
/// On an overrun it skips to the next grid point and counts the missed ticks; it never catches up.
/// Construct and destroy on the thread that owns the session; a scene must have been written to the seam first.
class ServoLoop {
 public:
  ServoLoop(HapticDevice& device, const DeviceDescription& description, double rate, ServoSeams& seams);
  ~ServoLoop();
  ServoLoop(const ServoLoop&) = delete;
  ServoLoop& operator=(const ServoLoop&) = delete;

  /// Starts the device and the thread. Throws what HapticDevice::start throws, std::logic_error where no scene was
  /// written to the seam, and nothing changes where it runs already.
  Scheduling start();
  /// Stops thread and device; safe to call twice.
  void stop();

 private:
  void run() noexcept;

  HapticDevice& device_;
  HapticTick tick_;
  double rate_;
  Scheduling scheduling_;
  ServoSeams& seams_;
  std::atomic<bool> running_ = false;
  std::thread thread_;
};

}  // namespace haptiv
