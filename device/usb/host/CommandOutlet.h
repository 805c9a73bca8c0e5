#pragma once

#include <atomic>

#include "device/realtime/TimeHistogram.h"
#include "device/realtime/TripleBuffer.h"
#include "device/usb/host/LinkCounters.h"
#include "device/usb/protocol/StreamFrames.h"

namespace haptiv::usb {

/// Takes commands from the servo, the newest only, and makes packets of them; knows by the board's echo how long they
/// are on their way, and whether the board brakes. The echo of each kTimed-th is waited for, to be timed: nobody else
/// needs it before the servo reads again.
class CommandOutlet {
 public:
  static constexpr std::uint32_t kTimed = 8;

  explicit CommandOutlet(LinkCounters& counters) : counters_(counters) {}

  /// The heartbeat is this call. Thread: the servo.  Realtime-safe: yes.
  void write(const DeviceCommand& drive, bool reset, bool trip) noexcept;

  /// A device has been opened: what was written before is not for it. Thread: the link's, or before it runs.
  void begin(FrameForm form) noexcept;
  /// The packet of the newest command, numbered; 0: there is none that is new. Thread: the link's.
  /// @param echo  number of the newest command that the board has accepted
  std::size_t packet(std::span<std::uint8_t> out, std::uint32_t echo) noexcept;
  /// The newest command is not sent. Thread: the link's.
  void skip() noexcept;
  /// The board has accepted commands up to this one. Thread: the link's.
  void echoed(std::uint32_t sequence) noexcept;

  /// A command is being timed: neither its echo nor a later one has come. Thread: the link's.
  bool awaitsEcho() const noexcept { return timed_.writtenAt != 0; }

  /// No command since the last one that the board is known to have accepted lets the drives on. Thread: any.
  bool braked() const noexcept { return braked_; }
  /// From `write` until the echo came in [ns], of those that were timed. Thread: any.
  TimeDistribution latencies() const { return latencies_.distribution(); }

 private:
  struct Outgoing {
    BoardCommand command;
    std::int64_t writtenAt = 0;  ///< [ns]
  };
  struct Timed {
    std::uint32_t sequence = 0;
    std::int64_t writtenAt = 0;  ///< 0: none
  };

  LinkCounters& counters_;
  TripleBuffer<Outgoing> commands_;
  std::uint32_t heartbeat_ = 0;  // the servo's

  FrameForm form_ = FrameForm::full;
  bool numbered_ = false;  // sequence_ follows the board's
  std::uint32_t sequence_ = 0;
  std::uint32_t brakedSince_ = 0;  // the number of the first command of those that brake
  bool brakes_ = true;             // the newest one
  Timed timed_;
  std::atomic<bool> braked_ = true;
  TimeHistogram latencies_;
};

}  // namespace haptiv::usb
